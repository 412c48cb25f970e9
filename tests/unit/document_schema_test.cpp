// SPDX-License-Identifier: GPL-3.0-or-later
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <vector>

#include "document/document_json.h"
#include "document_support.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::document_schema_test {

using namespace test;

namespace {

struct Run {
    int status = -1;
    QString said;
};

Run python(const QString& program, const QStringList& arguments) {
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(program, arguments);
    if (!process.waitForFinished(60'000) || process.exitStatus() != QProcess::NormalExit) {
        return {};
    }
    return {process.exitCode(), QString::fromUtf8(process.readAll())};
}

/// The first that has the package jsonschema; empty: none.
QString pythonWithSchemas() {
    for (const char* program : {"python3", "/usr/bin/python3"}) {
        if (python(QLatin1String(program), {"-c", "import jsonschema"}).status == 0) {
            return QLatin1String(program);
        }
    }
    return {};
}

constexpr const char* kSchema = HITSCOPE_SHADERS "/../resources/schemas/session.schema.json";

/// `within` with the value at "hits/0/power"; undefined: without it.
QJsonValue changed(const QJsonValue& within, const QStringList& path, const QJsonValue& value) {
    if (path.isEmpty()) {
        return value;
    }
    if (within.isArray()) {
        QJsonArray array = within.toArray();
        array[path.first().toInt()] = changed(array.at(path.first().toInt()), path.mid(1), value);
        return array;
    }
    QJsonObject object = within.toObject();
    const QJsonValue now = changed(object.value(path.first()), path.mid(1), value);
    if (now.isUndefined()) {
        object.remove(path.first());
    } else {
        object.insert(path.first(), now);
    }
    return object;
}

/// A place in exampleDocument(), and what stands there instead.
struct Instead {
    QString path;
    QJsonValue value;
};

/// A number that may be from `least` to `most`.
struct Range {
    const char* path;
    double least;
    double most;
};

constexpr double kFloat = 3.4e38;
constexpr double kLongestStep = 1.0 / 60.0;
constexpr Range kRanges[] = {{"scene/floor_height", -kFloat, kFloat},
                             {"scene/lights_extent", 0.0, kFloat},
                             {"scene/cover_texture", 0.0, 16384.0},
                             {"constants/max_distance", 0.001, 100.0},
                             {"constants/power", 0.0, 100.0},
                             {"constants/max_magnitude", 0.0, 100.0},
                             {"projectile/speed", 0.0, 1e9},
                             {"projectile/radius", 1e-7, 1e5},
                             {"projectile/mass", 1e-9, 1e9},
                             {"projectile/lifetime", 0.0, 3600.0},
                             {"projectile/rate_of_fire", 0.1, 240.0},
                             {"projectile/most_alive", 1.0, 5000.0},
                             {"projectile/reference_impulse", 0.001, 1e6},
                             {"projectile/gravity", 0.0, 1e7},
                             {"projectile/colour/1", 0.0, 1.0},
                             {"simulation/physics_step", 0.0005, kLongestStep},
                             {"simulation/time_scale", 0.01, 10.0},
                             {"simulation/time", 0.0, 1e12},
                             {"lights/spot/inner_angle", 0.0, 3.15},
                             {"lights/spot/outer_angle", 0.0, 3.15},
                             {"lights/spot/terms/ambient", 0.0, kFloat},
                             {"lights/point_2/terms/colour/2", 0.0, kFloat},
                             {"lights/point_4/attenuation/quadratic", 0.0, kFloat},
                             {"display/before_after/wipe_at", 0.0, 1.0},
                             {"display/before_after/exaggeration", 1.0, 20.0},
                             {"targets/1/source/resolution", 9.0, 1732.0},
                             {"targets/1/source/size", 1e-6, 1e9},
                             {"targets/1/mesh_steps/0/edge_length", 1e-37, kFloat},
                             {"targets/1/mesh_steps/0/region/balls/0/radius", 0.0, kFloat},
                             {"targets/1/mesh_steps/2/share", 1e-37, 0.999999},
                             {"targets/1/mesh_steps/3/passes", 1.0, 1000.0},
                             {"targets/1/physics/mass", 0.001, 1e6},
                             {"targets/1/physics/friction", 0.0, 10.0},
                             {"targets/1/physics/restitution", 0.0, 1.0},
                             {"hits/0/max_distance", 1.1e-9, 1e9},
                             {"hits/0/power", 0.0, 1e18},
                             {"hits/0/max_magnitude", 0.0, 1e9},
                             {"hits/0/speed", -kFloat, kFloat},
                             {"hits/0/point/0", -kFloat, kFloat},
                             {"hits/0/triangle", 0.0, 4294967295.0},
                             {"hits/0/pipeline", 0.0, 255.0}};

/// Of every number with a range its ends, and what lies just beyond them.
std::vector<Instead> ends() {
    std::vector<Instead> all;
    for (const Range& range : kRanges) {
        const double step = 0.01 * std::max({1e-300, std::abs(range.least), std::abs(range.most)});
        const QString path = QLatin1String(range.path);
        all.insert(all.end(), {{path, range.least}, {path, range.most}});
        const bool isWhole = range.most - std::floor(range.most) == 0.0 && range.most < 1e7;
        all.insert(all.end(), {{path, range.least > 0.0 ? 0.5 * range.least : range.least - step},
                               {path, range.most + (isWhole ? std::ceil(step) : 3.0 * step)},
                               {path, QStringLiteral("1")}});
    }
    return all;
}

std::vector<Instead> others() {
    const QJsonValue none(QJsonValue::Undefined);
    const QJsonArray longAxis{0.0, 2.0, 0.0};
    return {{"targets/1/source/shape", "cube"},
            {"targets/1/source/shape", "lump"},
            {"targets/1/source/shape", none},
            {"targets/2/id", 0},
            {"targets/2/id", 2147483647},
            {"targets/2/id", 2147483648.0},
            {"targets/0/source/path", none},
            {"targets/0/source/sha256", "AB"},
            {"targets/0/source/size", -1},
            {"targets/0/name", QString(10'001, u'a')},
            {"targets/0/rotation", QJsonArray{2.0, 0.0, 0.0, 0.0}},
            {"targets/0/rotation", QJsonArray{1.0, 0.0, 0.0}},
            {"targets/0/placement/scale", 0.0},
            {"targets/1/mesh_steps/0/edge_length", none},
            {"targets/1/mesh_steps/0/method", "by hand"},
            {"targets/1/mesh_steps/2/share", 1.0},
            {"targets/1/mesh_steps/1/kind", "only-object"},
            {"display/cutting_plane/normal", longAxis},
            {"display/wireframe", "on"},
            {"cameras/current", "nowhere"},
            {"cameras/current", "camera " + QString(10'000, u' ')},
            {"positions/0/fingerprint", "0123"},
            {"selection/hit", -1},
            {"selection/picked/vertex", none},
            {"hits/0/point", none},
            {"hits/0/point", QJsonArray{0.0, 1.0}},
            {"hits/0/dent_direction", "press"},
            {"hits/0/group", "scatter 12"},
            {"hits/0/group", "scatter 0"},
            {"hits/0/group", "scatter 123456789012"},
            {"hits/0/curve", QJsonArray{0, 1, 0, 1, 0, 1, 0}},
            {"hits/0/curve", QJsonArray{0, 1, 0, 1, 0, 1, 0, 1.5}},
            {"hits/0/enabled", 1},
            {"version", none}};
}

}  // namespace

/// What is written is as the schema beside the program says, and the schema lets nothing pass that is
/// refused.
class DocumentSchemaTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void files_data();
    void files();
    void agreesWithTheReader();

private:
    QTemporaryDir m_folder;
    QString m_python;
};

void DocumentSchemaTest::initTestCase() {
    m_python = pythonWithSchemas();
    if (m_python.isEmpty()) {
        QSKIP("Python's package jsonschema is not here.");
    }
}

void DocumentSchemaTest::files_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("problem");
    SessionDocument document = exampleDocument();
    QTest::newRow("one of everything") << writeDocument(document) << QString();
    QTest::newRow("nothing") << writeDocument(SessionDocument()) << QString();
    for (int mesh = 0; mesh < 7; ++mesh) {
        document.targets[static_cast<std::size_t>(mesh % 3)].source.mesh = static_cast<BuiltInMesh>(mesh);
    }
    document.targets[2].source = {};
    document.hits[0].pipeline = 200;
    document.hits[1].pipeline = kUnknownPipeline;
    document.cameras.current.clear();
    document.selection = {};
    QTest::newRow("others") << writeDocument(document) << QString();
    // That the schema says something.
    QTest::newRow("newer") << writeDocument(document).replace("\"version\": 1", "\"version\": 2")
                           << "version";
    QTest::newRow("unknown") << writeDocument(document).replace("\"impulse\"", "\"oomph\"") << "oomph";
    QTest::newRow("wrong kind") << writeDocument(document).replace("\"impulse\": 41", "\"impulse\": \"41\"")
                                << "is not of type";
}

void DocumentSchemaTest::files() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, problem);
    const QString file = writeFile(m_folder.path(), QStringLiteral("a.hitscope"), bytes.toStdString());
    const Run run =
        python(m_python, {"-c",
                          "import json, sys, jsonschema\n"
                          "schema = json.load(open(sys.argv[1], encoding='utf-8'))\n"
                          "jsonschema.Draft202012Validator.check_schema(schema)\n"
                          "checker = jsonschema.Draft202012Validator(schema)\n"
                          "problems = [str(list(e.absolute_path)) + ' ' + e.message "
                          "for e in checker.iter_errors(json.load(open(sys.argv[2], encoding='utf-8')))]\n"
                          "print('\\n'.join(problems))\n"
                          "sys.exit(1 if problems else 0)\n",
                          QLatin1String(kSchema), file});
    if (problem.isEmpty()) {
        QVERIFY2(run.status == 0, qPrintable(run.said));
    } else {
        QCOMPARE(run.status, 1);
        QVERIFY2(run.said.contains(problem), qPrintable(run.said));
    }
}

void DocumentSchemaTest::agreesWithTheReader() {
    const QJsonValue example = QJsonDocument::fromJson(writeDocument(exampleDocument())).object();
    std::vector<Instead> all = ends();
    const std::vector<Instead> more = others();
    all.insert(all.end(), more.begin(), more.end());
    QStringList files;
    for (const Instead& instead : all) {
        const QJsonValue made = changed(example, instead.path.split(u'/'), instead.value);
        files << writeFile(m_folder.path(), QStringLiteral("%1.json").arg(files.size()),
                           QJsonDocument(made.toObject()).toJson().toStdString());
    }
    const Run run = python(m_python, QStringList{"-c",
                                                 "import json, sys, jsonschema\n"
                                                 "schema = json.load(open(sys.argv[1], encoding='utf-8'))\n"
                                                 "checker = jsonschema.Draft202012Validator(schema)\n"
                                                 "for name in sys.argv[2:]:\n"
                                                 "    file = json.load(open(name, encoding='utf-8'))\n"
                                                 "    print('yes' if checker.is_valid(file) else 'no')\n",
                                                 QLatin1String(kSchema)} +
                                         files);
    QVERIFY2(run.status == 0, qPrintable(run.said));
    const QStringList verdicts = run.said.split(u'\n', Qt::SkipEmptyParts);
    QCOMPARE(verdicts.size(), files.size());
    QStringList different;
    for (qsizetype i = 0; i < files.size(); ++i) {
        const Result<SessionDocument> document = readDocument(QByteArray::fromStdString(readFile(files[i])));
        if ((verdicts[i] == QStringLiteral("yes")) != document.ok()) {
            const Instead& instead = all[static_cast<std::size_t>(i)];
            const QByteArray value = QJsonDocument(QJsonArray{instead.value}).toJson(QJsonDocument::Compact);
            different << instead.path + u' ' + QString::fromUtf8(value.left(80)) + u' ' + verdicts[i];
        }
    }
    QVERIFY2(different.isEmpty(), qPrintable(different.join(u'\n')));
}

HITSCOPE_TEST(DocumentSchemaTest, QCoreApplication)

}  // namespace hitscope::document_schema_test

#include "document_schema_test.moc"
