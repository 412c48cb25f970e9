// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh > Refine, Simplify and Smooth by hand: the dialogs say what the mesh would have, and it has it.
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <algorithm>

#include "app/dialogs/mesh_step_dialog.h"
#include "app/dialogs/scale_dialog.h"
#include "io/import.h"
#include "mesh/same_bits.h"
#include "models/quantity_text.h"
#include "panels/fields/number_box.h"
#include "session/export/export_target.h"
#include "session/task_list.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::mesh_dialogs_test {

class MeshDialogsTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow([](Session& session) { loadMesh(session, makeLowPolyCube(2.5f)); });
    }
    void cleanup() { dropWindow(); }
    void refineKeepsVerticesAndHits();
    void refineProposesWhatChangesTheMesh();
    void exportedComesBack();
    void saysWhatIsWrong();
    void simplifyAndSmoothApplyHits();
    void cancelChangesNothing();
    void returnAccepts_data();
    void returnAccepts();
    void undoCancelsWhatIsBeingDone();
    void whatWasUndoneMeanwhileStays();
    void targetsStand();
    void objectsBecomeTargets();
    void aTargetIsScaled();

private:
    [[nodiscard]] const Target& target() const { return *m_session->targets().front(); }
    [[nodiscard]] const MeshData& mesh() const { return *target().shape.mesh; }
    void hit();
    [[nodiscard]] QAction* action(const QString& text) const;
    /// Null, with the test failed: it does not open.
    [[nodiscard]] MeshStepDialog* open(const QString& action);
    template <class Part>
    [[nodiscard]] static Part& part(MeshStepDialog& dialog, const char* name) {
        return *dialog.findChild<Part*>(QLatin1String(name));
    }
    static void type(MeshStepDialog& dialog, const char* box, const char* text);
    /// The preview's text, when it is there.
    [[nodiscard]] static QString result(MeshStepDialog& dialog);
    /// Presses the button and waits until the mesh is another.
    void accept(MeshStepDialog& dialog);
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
        makeActive(*m_window);
        QTest::keyClick(m_window.get(), key, modifiers);
    }
};

void MeshDialogsTest::hit() {
    Hit hit;
    hit.target = target().id;
    hit.point = {0.2f, 2.5f, 0.3f};
    hit.direction = {0.0f, -1.0f, 0.0f};
    hit.constants = {0.5f, 1.2f, 0.4f};
    QVERIFY(m_session->hits().add(hit).ok());
}

MeshStepDialog* MeshDialogsTest::open(const QString& action) {
    for (QAction* candidate : m_window->findChildren<QAction*>()) {
        if (candidate->text().remove(u'&') == action && candidate->isEnabled()) {
            candidate->trigger();
            break;
        }
    }
    auto* dialog = m_window->findChild<MeshStepDialog*>();
    return dialog != nullptr && QTest::qWaitForWindowExposed(dialog, kPatience) ? dialog : nullptr;
}

void MeshDialogsTest::type(MeshStepDialog& dialog, const char* box, const char* text) {
    makeActive(dialog);
    auto& field = part<QWidget>(dialog, box);
    field.setFocus();
    QTRY_VERIFY_WITH_TIMEOUT(field.hasFocus(), kPatience);  // a number counts when its field loses it
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, QLatin1String(text));
    QTest::keyClick(&field, Qt::Key_Tab);
    QTRY_VERIFY_WITH_TIMEOUT(!field.hasFocus(), kPatience);
}

QString MeshDialogsTest::result(MeshStepDialog& dialog) {
    const auto& label = part<QLabel>(dialog, "result");
    [&] { QTRY_VERIFY_WITH_TIMEOUT(label.text() != QStringLiteral("Computing…"), kPatience); }();
    // None of its lines is cut.
    [&] { QTRY_VERIFY_WITH_TIMEOUT(label.height() >= label.heightForWidth(label.width()), kPatience); }();
    return label.text();
}

void MeshDialogsTest::accept(MeshStepDialog& dialog) {
    const TargetId before = target().id;
    auto& button = part<QPushButton>(dialog, "accept");
    QTRY_VERIFY_WITH_TIMEOUT(button.isEnabled(), kPatience);  // what comes of it is known
    QTest::mouseClick(&button, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(target().id != before, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
}

void MeshDialogsTest::refineKeepsVerticesAndHits() {
    hit();
    const MeshData before = mesh();
    MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
    QVERIFY(dialog != nullptr);
    QCOMPARE(part<QComboBox>(*dialog, "region").currentIndex(), 2);  // where hits are
    type(*dialog, "edgeLength", "0.2");
    const QString said = result(*dialog);
    accept(*dialog);
    QVERIFY2(said.startsWith(QStringLiteral("Vertices: %1 → %2. Faces: %3 → %4.")
                                 .arg(before.vertexCount())
                                 .arg(mesh().vertexCount())
                                 .arg(before.faceCount())
                                 .arg(mesh().faceCount())),
             qPrintable(said));
    QVERIFY(mesh().vertexCount() > before.vertexCount() + 50);
    QVERIFY(std::equal(before.positions.begin(), before.positions.end(), mesh().positions.begin(), sameBits));
    QCOMPARE(m_session->hits().history().size(), std::size_t(1));
    QCOMPARE(m_session->hits().history().hits()[0].target, target().id);
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(mesh().vertexCount(), before.vertexCount(), kPatience);
    key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(mesh().vertexCount() > before.vertexCount() + 50, kPatience);
}

void MeshDialogsTest::refineProposesWhatChangesTheMesh() {
    hit();
    for (int time = 0; time < 3; ++time) {  // the first has edges short enough for the hit
        const std::size_t before = mesh().vertexCount();
        MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
        QVERIFY(dialog != nullptr);
        const QString said = result(*dialog);
        QVERIFY2(said.startsWith(QStringLiteral("Vertices: ")), qPrintable(said));
        accept(*dialog);
        QVERIFY(mesh().vertexCount() > before);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<MeshStepDialog*>() == nullptr, kPatience);
    }
}

/// In each format that keeps vertices apart the dented shape comes back.
void MeshDialogsTest::exportedComesBack() {
    hit();
    MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
    QVERIFY(dialog != nullptr);
    type(*dialog, "edgeLength", "0.3");
    accept(*dialog);
    QTRY_VERIFY_WITH_TIMEOUT(target().deformed.positions()[0] == mesh().positions[0], kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(
        !std::equal(mesh().positions.begin(), mesh().positions.end(), target().deformed.positions().begin()),
        kPatience);
    const std::vector<glm::vec3> now(target().deformed.positions().begin(),
                                     target().deformed.positions().end());
    const QTemporaryDir folder;
    for (const char* name : {"dented.obj", "dented.ply"}) {
        const QString path = folder.filePath(QLatin1String(name));
        ExportOptions options;
        options.format = name[7] == 'o' ? ExportFormat::Obj : ExportFormat::Ply;
        QVERIFY(exportTarget(*m_session, target(), path, options).ok());
        const Result<ImportedMesh> read = importMesh(path);
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
        QCOMPARE(read.value().mesh.positions.size(), now.size());
        QVERIFY2(std::equal(now.begin(), now.end(), read.value().mesh.positions.begin(), sameBits), name);
        QCOMPARE(read.value().mesh.faceCount(), mesh().faceCount());
    }
}

void MeshDialogsTest::saysWhatIsWrong() {
    MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
    QVERIFY(dialog != nullptr);
    type(*dialog, "edgeLength", "0.000001");
    QVERIFY2(result(*dialog).contains(QStringLiteral("edge length"), Qt::CaseInsensitive),
             qPrintable(result(*dialog)));
    QVERIFY(!part<QPushButton>(*dialog, "accept").isEnabled());
    type(*dialog, "edgeLength", "0.3");
    QVERIFY(!part<QPushButton>(*dialog, "accept").isEnabled());
    QVERIFY(result(*dialog).startsWith(QStringLiteral("Vertices: ")));
    QVERIFY(part<QPushButton>(*dialog, "accept").isEnabled());
    type(*dialog, "edgeLength", "9");
    QVERIFY(result(*dialog).startsWith(QStringLiteral("The mesh stays as it is")));
    QVERIFY(!part<QPushButton>(*dialog, "accept").isEnabled());
    part<QComboBox>(*dialog, "method").setCurrentIndex(2);
    QVERIFY(!part<QCheckBox>(*dialog, "keepQuads").isEnabled());
    dialog->reject();
}

void MeshDialogsTest::simplifyAndSmoothApplyHits() {
    hit();
    MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
    QVERIFY(dialog != nullptr);
    type(*dialog, "edgeLength", "0.3");
    part<QComboBox>(*dialog, "region").setCurrentIndex(0);
    accept(*dialog);
    const std::size_t fine = mesh().faceCount();
    for (const char* name : {"Smooth…", "Simplify…"}) {
        dialog = open(QString::fromUtf8(name));
        QVERIFY2(dialog != nullptr, name);
        auto& apply = part<QCheckBox>(*dialog, "applyHits");
        const bool isFirst = name[1] == 'm';
        QCOMPARE(apply.isEnabled(), isFirst);  // the second time there are no hits any more
        QCOMPARE(apply.isChecked(), isFirst);
        const auto& number = part<QSpinBox>(*dialog, isFirst ? "passes" : "share");
        QCOMPARE(number.findChild<QLineEdit*>()->selectedText(), number.cleanText());  // typing replaces it
        QVERIFY(part<QPushButton>(*dialog, "accept").isDefault());
        if (!isFirst) {
            type(*dialog, "share", "25");
        }
        const QString said = result(*dialog);
        accept(*dialog);
        QVERIFY(m_session->hits().history().hits().empty());
        QVERIFY2(said.endsWith(QStringLiteral("→ %1.").arg(countText(mesh().faceCount()))), qPrintable(said));
    }
    QVERIFY(mesh().faceCount() < fine / 2);
    // The dent is in the original now: what was the flat top is not flat any more.
    const auto lowest = std::count_if(mesh().positions.begin(), mesh().positions.end(), [](const auto& at) {
        return at.y < 2.4f && std::abs(at.x - 0.2f) < 0.6f && std::abs(at.z - 0.3f) < 0.6f && at.y > 1.0f;
    });
    QVERIFY(lowest > 0);
}

void MeshDialogsTest::cancelChangesNothing() {
    const TargetId before = target().id;
    MeshStepDialog* dialog = open(QStringLiteral("Smooth…"));
    QVERIFY(dialog != nullptr);
    QVERIFY(!result(*dialog).isEmpty());
    QTest::keyClick(dialog, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<MeshStepDialog*>() == nullptr, kPatience);
    QCOMPARE(target().id, before);
    QVERIFY(!m_session->steps().canUndo() ||
            m_session->steps().toUndo()->kind == SessionUndo::Kind::LoadScene);
}

void MeshDialogsTest::returnAccepts_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<QByteArray>("box");
    QTest::addColumn<QString>("text");
    QTest::newRow("simplify") << QStringLiteral("Simplify…") << QByteArray("share") << QString();
    QTest::newRow("smooth") << QStringLiteral("Smooth…") << QByteArray("passes") << QString();
    QTest::newRow("refine") << QStringLiteral("Refine…") << QByteArray("edgeLength") << QStringLiteral("0.2");
}

/// Once, whether it is known what comes of it or not yet.
void MeshDialogsTest::returnAccepts() {
    QFETCH(const QString, action);
    QFETCH(const QByteArray, box);
    QFETCH(const QString, text);
    for (const bool waits : {false, true}) {
        hit();
        const TargetId before = target().id;
        MeshStepDialog* dialog = open(action);
        QVERIFY(dialog != nullptr);
        makeActive(*dialog);
        auto& field = part<QWidget>(*dialog, box.constData());
        QTRY_VERIFY_WITH_TIMEOUT(field.hasFocus(), kPatience);
        if (waits) {
            QVERIFY(!result(*dialog).isEmpty());
        }
        QTest::keyClicks(&field, text);
        QTest::keyClick(&field, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(target().id != before, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<MeshStepDialog*>() == nullptr, kPatience);
        m_session->undo();  // what is refined already stays as it is
    }
}

void MeshDialogsTest::undoCancelsWhatIsBeingDone() {
    hit();
    const TargetId before = target().id;
    MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
    QVERIFY(dialog != nullptr);
    type(*dialog, "edgeLength", "0.01");
    QVERIFY(!result(*dialog).isEmpty());
    QTest::mouseClick(&part<QPushButton>(*dialog, "accept"), Qt::LeftButton);
    QVERIFY(m_session->tasks().current() != nullptr);
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_session->hits().history().size(), std::size_t(1));
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
    QTest::qWait(300);
    QCOMPARE(target().id, before);
}

/// By other ways than the key.
void MeshDialogsTest::whatWasUndoneMeanwhileStays() {
    hit();
    const TargetId before = target().id;
    MeshStepDialog* dialog = open(QStringLiteral("Refine…"));
    QVERIFY(dialog != nullptr);
    part<QComboBox>(*dialog, "region").setCurrentIndex(0);
    type(*dialog, "edgeLength", "0.1");
    QVERIFY(!result(*dialog).isEmpty());
    QTest::mouseClick(&part<QPushButton>(*dialog, "accept"), Qt::LeftButton);
    m_session->undo();
    QTRY_VERIFY_WITH_TIMEOUT(m_session->tasks().current() == nullptr, kPatience);
    QCOMPARE(target().id, before);
    QVERIFY(m_session->steps().canRedo());
}

void MeshDialogsTest::aTargetIsScaled() {
    hit();
    const Bounds before = target().worldBounds();
    const TargetId id = target().id;
    for (QAction* action : m_window->findChildren<QAction*>()) {
        if (action->text().remove(u'&') == QStringLiteral("Scale…")) {
            action->trigger();
        }
    }
    auto* dialog = m_window->findChild<ScaleDialog*>();
    QVERIFY(dialog != nullptr);
    makeActive(*dialog);
    auto* extent = dialog->findChild<NumberBox*>(QStringLiteral("extent"));
    auto* factor = dialog->findChild<NumberBox*>(QStringLiteral("factor"));
    QTRY_VERIFY_WITH_TIMEOUT(extent->hasFocus(), kPatience);
    QCOMPARE(extent->value(), 5.0);
    QTest::keyClick(extent, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(extent, QStringLiteral("50 cm"));
    QTest::keyClick(extent, Qt::Key_Tab);
    QCOMPARE(factor->value(), 0.1);
    QTest::keyClick(factor, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(factor, QStringLiteral("0.2"));
    QTest::keyClick(factor, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(target().id != id, kPatience);
    QCOMPARE(target().extent(), 1.0f);
    QCOMPARE(target().worldBounds().min.y, before.min.y);
    QVERIFY(m_session->targets().isSelected(target().id));
    QCOMPARE(m_session->hits().history().size(), std::size_t{1});
    QVERIFY(m_window->viewport().syncNow().ok());
    QVERIFY(target().deformed.statistics().changedVertices > 0);
    key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(target().id, id);
    QVERIFY(target().worldBounds().max == before.max);
}

QAction* MeshDialogsTest::action(const QString& text) const {
    const auto actions = m_window->findChildren<QAction*>();
    return *std::find_if(actions.begin(), actions.end(),
                         [&text](const QAction* action) { return action->text().remove(u'&') == text; });
}

void MeshDialogsTest::targetsStand() {
    MeshData tower = mesh();
    for (glm::vec3& position : tower.positions) {
        position *= glm::vec3(1.0f, 1.0f, 3.0f);
    }
    loadMesh(*m_session, std::move(tower));
    const float floor = m_session->targets().floorHeight();
    const glm::vec3 before = target().worldBounds().size();
    action(QStringLiteral("Turn Upright"))->trigger();
    const Bounds turned = target().worldBounds();
    QVERIFY(std::abs(turned.size().y - before.z) < 1.0e-3f && std::abs(turned.min.y - floor) < 1.0e-3f);
    QVERIFY(m_session->targets().setTransform(target().id, {{0.0f, 20.0f, 0.0f}, {}}).ok());
    action(QStringLiteral("Set on the Floor"))->trigger();
    QVERIFY(std::abs(target().worldBounds().min.y - floor) < 1.0e-3f);
}

void MeshDialogsTest::objectsBecomeTargets() {
    const auto separate = [this] { return action(QStringLiteral("Separate Objects")); };
    QVERIFY(!separate()->isEnabled());  // the cube is one
    MeshData two = mesh();
    two.groups = {{FaceGroup::Kind::Object, "lower", 0},
                  {FaceGroup::Kind::Object, "upper", static_cast<std::uint32_t>(two.faceCount() / 2)}};
    const std::size_t faces = two.faceCount();
    loadMesh(*m_session, std::move(two));
    hit();
    QTRY_VERIFY_WITH_TIMEOUT(separate()->isEnabled(), kPatience);
    separate()->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().size(), std::size_t(2), kPatience);
    QCOMPARE(target().name, QStringLiteral("lower"));
    QCOMPARE(m_session->targets().back()->name, QStringLiteral("upper"));
    QCOMPARE(mesh().faceCount() + m_session->targets().back()->shape.mesh->faceCount(), faces);
    QVERIFY(!separate()->isEnabled());
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(m_session->targets().size(), std::size_t(1), kPatience);
    QCOMPARE(mesh().faceCount(), faces);
    QCOMPARE(m_session->hits().history().size(), std::size_t(1));
}

HITSCOPE_TEST(MeshDialogsTest, QApplication)

}  // namespace hitscope::mesh_dialogs_test

#include "mesh_dialogs_test.moc"
