// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as it is shown, in every format, and what is read back from it.
#include <QDir>
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>
#include <glm/geometric.hpp>

#include "core/parallel.h"
#include "io/import.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/export/export_target.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::export_formats_test {

namespace {

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class ExportFormatsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }
    void everyFormatIsReadBackAsMeant_data();
    void everyFormatIsReadBackAsMeant();
    void theWorldIsWhereTargetsStand();
    void stepsAreInTheEstimate();
    void hitsAreCounted();
    void stepsLeadToTheShapeShown();
    void hitsNotShownAreLeftOut();
    void whatIsNotAsMeantIsSaid();
    void theProgressNamesEveryStep_data();
    void theProgressNamesEveryStep();
    void theSourceIsReadFirst();
    void endsSoonWhereNobodyWantsIt_data();
    void endsSoonWhereNobodyWantsIt();

private:
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] const Target& target(std::size_t index) const { return *m_session->targets()[index]; }
    [[nodiscard]] std::vector<const Target*> both() const { return {&target(0), &target(1)}; }
    /// What progress says, each once in turn, of these targets; the share only grows, and goes on in each.
    QStringList steps(const std::vector<const Target*>& targets, const QString& name,
                      const ExportOptions& options) const {
        QStringList steps;
        double last = 0.0;
        double first = 0.0;  // of the step
        const auto told = [&](double share, const QString& doing) {
            if (steps.isEmpty() || steps.back() != doing) {
                steps << doing;
                first = share;
            }
            steps += share < last || share > 1.0 ? QStringList(QStringLiteral("back")) : QStringList();
            last = share;
            return true;
        };
        const bool isWritten =
            writeExport(copyForExport(*m_session, targets, options), path(name), told).ok();
        return isWritten && first > 0.0 && last > first ? steps : QStringList();
    }
    /// With several targets: all of them.
    Result<ExportReport> write(const std::vector<const Target*>& targets, const QString& name,
                               const ExportOptions& options) const {
        return writeExport(copyForExport(*m_session, targets, options), path(name));
    }
    [[nodiscard]] MeshData read(const QString& name) const {
        Result<ImportedMesh> imported = importMesh(path(name));
        return imported ? std::move(imported.value().mesh) : MeshData();
    }

    test::GlFixture m_gl;
    QTemporaryDir m_folder;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<SceneGpu> m_gpu;
};

void ExportFormatsTest::initTestCase() {
    if (!m_gl.open()) {
        return;
    }
    m_session = std::make_unique<Session>();
    std::vector<TargetPlan> plans;
    plans.push_back(planMesh(makeHighPolyCube(2.5f)));
    plans.push_back(planMesh(makeLowPolySphere(2.0f)));
    plans[0].name = QStringLiteral("cube");
    plans[1].name = QStringLiteral("sphere");
    plans[1].transform.position = {7.0f, 0.0f, -1.0f};
    plans[1].transform.rotation = glm::angleAxis(0.5f, glm::vec3(0, 1, 0));
    m_session->loadScene({QStringLiteral("two"), std::move(plans)});
    Result<std::unique_ptr<SceneGpu>> made = SceneGpu::create(*m_session);
    QVERIFY(made);
    m_gpu = std::move(made.value());
    shootAll(*m_session, demoShots(*m_session, 60, 2));
    QVERIFY(m_gpu->sync());
    for (std::size_t t = 0; t < 2; ++t) {
        QVERIFY(target(t).deformed.statistics().changedVertices > 0);
    }
}

void ExportFormatsTest::everyFormatIsReadBackAsMeant_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<bool>("all");
    for (const ExportFormatTraits& traits : exportFormats()) {
        QTest::addRow("%s, one", traits.key) << static_cast<int>(traits.format) << false;
        QTest::addRow("%s, all", traits.key) << static_cast<int>(traits.format) << true;
    }
}

void ExportFormatsTest::everyFormatIsReadBackAsMeant() {
    QFETCH(int, format);
    QFETCH(bool, all);
    const ExportFormatTraits& traits = traitsOf(static_cast<ExportFormat>(format));
    for (const NormalMode normals : {NormalMode::True, NormalMode::Paper}) {
        ExportOptions options;
        options.format = traits.format;
        options.normals = normals;
        options.readBack = true;
        options.steps = 7;
        const QString name = QStringLiteral("mesh.") + QLatin1String(traits.suffix);
        const Result<ExportReport> written = write(all ? both() : std::vector{&target(0)}, name, options);
        QVERIFY2(written.ok(), written.ok() ? "" : written.error().message().c_str());
        QCOMPARE(written.value().wasReadBack, traits.format != ExportFormat::Csv);
        QVERIFY(!contentOf(path(name)).isEmpty());
        if (traits.format == ExportFormat::Obj || traits.format == ExportFormat::Ply) {
            std::size_t vertices = target(0).deformed.positions().size();
            vertices += all ? target(1).deformed.positions().size() : 0;
            QCOMPARE(read(name).positions.size(), vertices);
        }
    }
}

void ExportFormatsTest::theWorldIsWhereTargetsStand() {
    ExportOptions options;
    options.inWorld = true;
    QVERIFY(write({&target(1)}, QStringLiteral("world.obj"), options));
    options.inWorld = false;
    QVERIFY(write({&target(1)}, QStringLiteral("file.obj"), options));
    const MeshData world = read(QStringLiteral("world.obj"));
    const MeshData file = read(QStringLiteral("file.obj"));
    QCOMPARE(world.cornerVertices, file.cornerVertices);
    float farthest = 0.0f;
    for (std::size_t v = 0; v < world.positions.size(); ++v) {
        const glm::vec3 expected = target(1).transform.toWorld(file.positions[v]);
        farthest = std::max(farthest, glm::distance(world.positions[v], expected));
    }
    QVERIFY2(farthest < 1e-5f, qPrintable(QString::number(farthest)));
    QVERIFY(glm::distance(world.positions[0], file.positions[0]) > 1.0f);
}

/// Before it is written, the dialog says how large a file will be; with steps, as many vertices again as the
/// hits move.
void ExportFormatsTest::stepsAreInTheEstimate() {
    ExportOptions options;
    options.format = ExportFormat::Glb;
    double without = 0.0;
    double withoutSaid = 0.0;
    for (const std::size_t steps : {0, 5, 60}) {
        options.steps = steps;
        QVERIFY(write(both(), QStringLiteral("sized.glb"), options));
        const auto written = static_cast<double>(QFileInfo(path(QStringLiteral("sized.glb"))).size());
        const auto said =
            static_cast<double>(estimateExport(both(), options, m_session->hits().shown()).bytes);
        if (steps == 0) {
            without = written;
            withoutSaid = said;
            QVERIFY2(said > 0.8 * written && said < 1.3 * written,
                     qPrintable(QStringLiteral("%1 of %2").arg(said).arg(written)));
            continue;
        }
        const double share = (said - withoutSaid) / (written - without);
        QVERIFY2(share > 0.7 && share < 1.5, qPrintable(QString::number(share)));
    }
}

void ExportFormatsTest::hitsAreCounted() {
    ExportOptions options;
    options.format = ExportFormat::Csv;
    QVERIFY(write({&target(0)}, QStringLiteral("changes.csv"), options));
    const QList<QByteArray> lines = contentOf(path(QStringLiteral("changes.csv"))).trimmed().split('\n');
    QCOMPARE(lines.size() - 1, qsizetype(target(0).deformed.statistics().changedVertices));
    const qsizetype column = lines.first().trimmed().split(',').indexOf("hits");
    QVERIFY(column > 0);
    for (qsizetype line = 1; line < lines.size(); ++line) {
        QVERIFY2(lines[line].trimmed().split(',').value(column).toInt() > 0, lines[line].constData());
    }
}

// The last step of the animation is what the pipeline made: the check after writing adds the steps up.
void ExportFormatsTest::stepsLeadToTheShapeShown() {
    ExportOptions options;
    options.format = ExportFormat::Glb;
    options.readBack = true;
    options.steps = 1000;
    const SceneExport whole = copyForExport(*m_session, both(), options);
    const Result<ExportReport> written = writeExport(whole, path(QStringLiteral("steps.glb")));
    QVERIFY2(written.ok(), written.ok() ? "" : written.error().message().c_str());
    const QByteArray glb = contentOf(path(QStringLiteral("steps.glb")));
    QVERIFY(glb.contains("Deformed"));
    QVERIFY(glb.contains("\"animations\""));
    QVERIFY2(!written.value().notes.join(u' ').contains(QStringLiteral("what is shown differs")),
             qPrintable(written.value().notes.join(u' ')));
    SceneExport fewer = whole;
    fewer.hits.resize(fewer.hits.size() / 2);  // they do not make what is shown
    const Result<ExportReport> other = writeExport(fewer, path(QStringLiteral("fewer.glb")));
    QVERIFY(other.ok());
    QVERIFY2(other.value().notes.join(u' ').contains(QStringLiteral("what is shown differs")),
             qPrintable(other.value().notes.join(u' ')));
}

void ExportFormatsTest::hitsNotShownAreLeftOut() {
    m_session->hits().show(10);
    const SceneExport some = copyForExport(*m_session, both(), {});
    m_session->hits().show({});
    QVERIFY(m_gpu->sync());
    const auto enabled =
        std::count_if(some.hits.begin(), some.hits.end(), [](const Hit& hit) { return hit.enabled; });
    QCOMPARE(enabled, 10);
}

void ExportFormatsTest::whatIsNotAsMeantIsSaid() {
    ExportOptions options;
    options.readBack = true;
    SceneExport what = copyForExport(*m_session, std::vector{&target(0)}, options);
    const QString name = path(QStringLiteral("broken.obj"));
    what.beforeStep = [&name] {
        QFile file(name);
        if (file.exists() && file.open(QIODevice::Append)) {  // it has its name
            file.write("v 1 2 3\n");
        }
    };
    const Result<ExportReport> written = writeExport(what, name);
    QVERIFY(!written.ok());
    QVERIFY(written.error().what.find("is not what was meant") != std::string::npos);
}

void ExportFormatsTest::theProgressNamesEveryStep_data() {
    QTest::addColumn<QStringList>("before");
    const QString preparing = QStringLiteral("Preparing");
    const QStringList counts{QStringLiteral("Counting hits for"), preparing};
    const QStringList replays{QStringLiteral("Computing steps for"), preparing};
    for (const char* const key : {"ply", "ply-ascii", "csv"}) {
        QTest::newRow(key) << counts;
    }
    for (const char* const key : {"glb", "gltf"}) {
        QTest::newRow(key) << replays;
    }
    for (const char* const key : {"obj", "stl"}) {
        QTest::newRow(key) << QStringList(preparing);
    }
}

void ExportFormatsTest::theProgressNamesEveryStep() {
    QFETCH(QStringList, before);
    const QByteArray key = QTest::currentDataTag();
    const auto traits = std::find_if(exportFormats().begin(), exportFormats().end(),
                                     [&key](const ExportFormatTraits& one) { return key == one.key; });
    ExportOptions options;
    options.format = traits->format;
    options.steps = 3;
    for (const bool isRead : {false, true}) {
        options.readBack = isRead;
        QStringList expected = before + QStringList(QStringLiteral("Writing"));
        if (isRead && traits->format != ExportFormat::Csv) {
            expected << QStringLiteral("Checking");
        }
        const QString name = QStringLiteral("told.") + QLatin1String(traits->suffix);
        for (QString& step : expected) {
            step += u' ' + name;
        }
        QCOMPARE(steps({&target(0)}, name, options), expected);
        QCOMPARE(steps(both(), name, options), expected);
    }
}

void ExportFormatsTest::theSourceIsReadFirst() {
    for (const char* const suffix : {"obj", "ply"}) {
        const QString name = QStringLiteral("source.") + QLatin1String(suffix);
        ExportOptions options;
        options.format = exportFormatOf(name).value();
        QVERIFY(write({&target(0)}, name, options));
        Session session;
        loadMesh(session, read(name), path(name));
        const Target* const copied = session.targets().front().get();
        QStringList said;
        QVERIFY(writeExport(copyForExport(session, {&copied, 1}, options),
                            path(QStringLiteral("copy.") + QLatin1String(suffix)),
                            [&said](double, const QString& doing) {
                                said += doing;
                                return true;
                            }));
        QVERIFY(said.contains(QStringLiteral("Reading ") + name));
        QVERIFY(said.last().startsWith(QStringLiteral("Writing copy.")));
    }
}

// How soon an export ends cannot depend on the machine in a test. Each pass over a mesh asks every 65,536
// vertices, faces or corners whether to go on: a pass that did not would be missing from the number of looks.
void ExportFormatsTest::endsSoonWhereNobodyWantsIt_data() {
    QTest::addColumn<int>("format");
    QTest::addColumn<int>("least");
    const auto row = [](ExportFormat format, int least) {
        QTest::newRow(traitsOf(format).key) << static_cast<int>(format) << least;
    };
    row(ExportFormat::Obj, 43);
    row(ExportFormat::Ply, 40);
    row(ExportFormat::PlyAscii, 42);
    row(ExportFormat::Stl, 25);
    row(ExportFormat::Glb, 175);
    row(ExportFormat::Gltf, 178);
    row(ExportFormat::Csv, 26);
}

void ExportFormatsTest::endsSoonWhereNobodyWantsIt() {
    QFETCH(const int, format);
    QFETCH(const int, least);
    constexpr int kSegments = 208;  // a million corners
    Session session;
    std::vector<TargetPlan> plans;
    plans.push_back(planMesh(makeCube(kSegments, 2.5f)));
    session.loadScene({QStringLiteral("cube"), std::move(plans)});
    const Result<std::unique_ptr<SceneGpu>> gpu = SceneGpu::create(session);
    QVERIFY(gpu);
    shootAll(session, demoShots(session, 4, 2));
    QVERIFY(gpu.value()->sync());
    ExportOptions options;
    options.format = static_cast<ExportFormat>(format);
    options.readBack = true;
    options.steps = 2;
    const Target* const target = session.targets().front().get();
    const SceneExport what = copyForExport(session, {&target, 1}, options);
    const QString file = path(QStringLiteral("cube.") + QLatin1String(traitsOf(options.format).suffix));
    QFile::remove(file);
    int questions = 0;
    int last = 0;   // while the file is not there yet
    int looks = 0;  // of those that are not a writer's, which each time is further
    double done = -1.0;
    const auto count = [&](double share, const QString&) {
        if (!QFile::exists(file)) {
            last = questions;
            looks += share == done ? 1 : 0;
        }
        done = share;
        ++questions;
        return true;
    };
    pretendedProcessors() = 1;  // all looks are this thread's
    const auto all = qScopeGuard([] { pretendedProcessors() = 0; });
    QVERIFY(writeExport(what, file, count));
    QVERIFY2(looks >= least, qPrintable(QString::number(looks)));
    for (int part = 0; part < 12; ++part) {
        QFile::remove(file);
        int left = last * part / 12;
        int after = 0;
        const Result<ExportReport> written = writeExport(what, file, [&left, &after](double, const QString&) {
            after += left < 0 ? 1 : 0;
            return --left >= 0;
        });
        QVERIFY(!written);
        QCOMPARE(QString::fromStdString(written.error().what), QStringLiteral("The export was cancelled."));
        QVERIFY(!QFile::exists(file));
        QVERIFY2(after <= 1, qPrintable(QString::number(after)));  // it does not go on for long
    }
}

HITSCOPE_TEST(ExportFormatsTest, QCoreApplication)

}  // namespace hitscope::export_formats_test

#include "export_formats_test.moc"
