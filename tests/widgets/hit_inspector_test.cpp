// SPDX-License-Identifier: GPL-3.0-or-later
// Editing hits while looking at them: the dock "Hit" and the handles in the picture.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/actions/hit_actions.h"
#include "mesh/primitives.h"
#include "models/hit_history_model.h"
#include "panels/fields/number_box.h"
#include "panels/hit_history/hit_history_panel.h"
#include "panels/hit_inspector/hit_inspector_panel.h"
#include "support/test_program.h"
#include "viewport/handles/handle_grip.h"
#include "viewport/inspect_tool.h"
#include "widgets/window_support.h"

namespace hitscope::hit_inspector_test {

namespace {

void mouse(QWidget* widget, QEvent::Type type, const QPointF& global, bool held) {
    QMouseEvent event(type, widget->mapFromGlobal(global), global,
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                      held ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(widget, &event);
}

}  // namespace

class HitInspectorTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init() {
        makeWindow();
        QVERIFY(m_session->simulation().hitscan(viewport().rayThrough({0.5, 0.5})));
        QVERIFY(m_session->simulation().hitscan(viewport().rayThrough({0.56, 0.5})));
        QVERIFY(viewport().syncNow().ok());
        dock()->raise();
    }
    void cleanup() { dropWindow(); }

    void aDentIsSelectedInThePicture() {
        QVERIFY(child<QLabel>("title")->text().startsWith(QStringLiteral("No hit is selected")));
        QVERIFY(!child<QWidget>("fields")->isEnabled());
        viewport().inspectTool().setTool(Tool::Inspect);
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center());
        QCOMPARE(m_session->hits().selected(), std::optional<std::size_t>(0));
        QVERIFY(child<QLabel>("title")->text().startsWith(QStringLiteral("Hit 1 on")));
        QVERIFY(child<QWidget>("fields")->isEnabled());
        QVERIFY(grip("hitSize")->isVisible());
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, QPoint(8, viewport().height() - 8));
        QVERIFY(!m_session->hits().selected());
        QVERIFY(!grip("hitSize")->isVisible());
    }

    void aSliderChangesThePictureAtOnce() {
        m_session->hits().select(1);
        const QList<QSlider*> sliders = dock()->findChildren<QSlider*>();
        const auto found = std::find_if(sliders.begin(), sliders.end(), [](const QSlider* one) {
            return one->accessibleName() == QLatin1String("Max distance");
        });
        QVERIFY(found != sliders.end());
        QSlider* slider = *found;
        const std::size_t before = changed();
        slider->setSliderDown(true);
        for (const int place : {520, 560, 640}) {
            slider->setValue(place);
            QVERIFY(viewport().syncNow().ok());
        }
        QTRY_VERIFY_WITH_TIMEOUT(hit(1).constants.maxDistance > 0.6f, kPatience);
        QVERIFY(viewport().syncNow().ok());
        QVERIFY(changed() > before);
        slider->setSliderDown(false);
        QCOMPARE(m_session->steps().toUndo(),
                 (SessionUndo::Name{SessionUndo::Kind::EditHit, 1, 2, UndoPart::MaxDistance}));
        m_session->undo();
        QCOMPARE(hit(1).constants.maxDistance, 0.5f);
        QCOMPARE(hit(0).constants.maxDistance, 0.5f);
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::Hit);
    }

    void aNumberIsTyped() {
        m_session->hits().select(0);
        auto* box = child<QDoubleSpinBox>("max_magnitude");
        box->setFocus();
        box->findChild<QLineEdit*>()->selectAll();
        QTest::keyClicks(box, QStringLiteral("0.45"));
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(viewport().hasFocus());
        QCOMPARE(hit(0).constants.maxMagnitude, 0.45f);
        QTest::keyClick(&viewport(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(hit(0).constants.maxMagnitude, 0.3f);
        QCOMPARE(box->text(), QStringLiteral("0.3 m"));
    }

    void presetsAndSeveralHits() {
        m_session->hits().select(1);
        HitEditing& editing = m_window->findChild<HitActions*>()->editing();
        auto* preset = child<QComboBox>("preset");
        QCOMPARE(preset->currentText(), QStringLiteral("Paper"));
        const int pinprick = preset->findText(QStringLiteral("Pinprick"));
        preset->setCurrentIndex(pinprick);
        Q_EMIT preset->activated(pinprick);
        QCOMPARE(hit(1).constants.maxDistance, 0.15f);
        QCOMPARE(hit(0).constants.maxDistance, 0.5f);
        // The paper's is of its form too.
        auto* profile = child<QComboBox>("profile");
        Q_EMIT profile->activated(static_cast<int>(DentProfile::Crater));
        QCOMPARE(hit(1).form.profile, DentProfile::Crater);
        QCOMPARE(preset->currentText(), QStringLiteral("Pinprick"));
        Q_EMIT preset->activated(preset->findText(QStringLiteral("Paper")));
        QCOMPARE(hit(1).form.profile, DentProfile::Paper);
        QCOMPARE(preset->currentText(), QStringLiteral("Paper"));
        Q_EMIT profile->activated(static_cast<int>(DentProfile::Crater));
        QCOMPARE(preset->currentText(), QString());
        Q_EMIT profile->activated(static_cast<int>(DentProfile::Paper));
        Q_EMIT preset->activated(pinprick);
        editing.select({0, 1});
        QVERIFY(child<QLabel>("title")->text().startsWith(QStringLiteral("2 hits")));
        auto* reach = child<QDoubleSpinBox>("max_distance");
        QVERIFY(reach->text().startsWith(QStringLiteral("differ")));
        QCOMPARE(preset->currentIndex(), -1);
        reach->setFocus();
        reach->findChild<QLineEdit*>()->selectAll();
        QTest::keyClicks(reach, QStringLiteral("0.15"));  // which one of them has already
        QTest::keyClick(reach, Qt::Key_Return);
        QCOMPARE(hit(0).constants.maxDistance, 0.15f);
        QCOMPARE(hit(1).constants.maxDistance, 0.15f);
        QCOMPARE(hit(0).constants.power, 0.05f);
        m_session->undo();
        QCOMPARE(hit(0).constants.maxDistance, 0.5f);
    }

    void theDirectionIsTurnedAndBack() {
        m_session->hits().select(1);
        const glm::vec3 shot = hit(1).direction;
        QVERIFY(child<QToolButton>("asShot")->isChecked());
        QTest::mouseClick(child<QToolButton>("intoSurface"), Qt::LeftButton);
        QVERIFY(glm::distance(hit(1).direction, -hit(1).normal) < 1.0e-5f);
        auto* elevation = child<QDoubleSpinBox>("elevation");
        elevation->setFocus();
        elevation->findChild<QLineEdit*>()->selectAll();
        QTest::keyClicks(elevation, QStringLiteral("-90"));
        QTest::keyClick(elevation, Qt::Key_Return);
        QVERIFY(glm::distance(hit(1).direction, glm::vec3(0.0f, -1.0f, 0.0f)) < 1.0e-5f);
        QVERIFY(!child<QToolButton>("asShot")->isChecked());
        QTest::mouseClick(child<QToolButton>("asShot"), Qt::LeftButton);
        QVERIFY(hit(1).direction == shot);
        QVERIFY(hit(1).flight == glm::vec3(0.0f));
    }

    /// Of several hits only the angle that is edited becomes the same.
    void anAngleIsTypedForHitsThatDiffer() {
        Hit third = hit(1);
        third.direction = {0.0f, -1.0f, 0.0f};  // which has no azimuth
        QVERIFY(m_session->hits().add(third));
        Hit turned = hit(1);
        turned.direction = glm::normalize(glm::vec3(0.3f, -0.6f, -0.5f));
        QVERIFY(m_session->hits().replace(1, turned));
        m_session->hits().select(1);
        HitEditing& editing = m_window->findChild<HitActions*>()->editing();
        m_window->findChild<HitHistoryPanel*>()->findChild<QTableView*>(QStringLiteral("table"))->selectAll();
        QCOMPARE(editing.rows().size(), std::size_t{3});
        const std::vector<Hit> before = {hit(0), hit(1), hit(2)};
        type("azimuth", QStringLiteral("40"));
        QCOMPARE(editing.rows().size(), std::size_t{3});
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(std::abs(hit(i).direction.y - before[i].direction.y) < 1.0e-5f);
            QVERIFY(std::abs(azimuthOf(hit(i)) - 40.0) < 1.0e-3);
        }
        QVERIFY(hit(2) == before[2]);
        m_session->undo();
        QVERIFY(hit(1) == before[1]);
        type("elevation", QStringLiteral("-20"));
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY(std::abs(azimuthOf(hit(i)) - azimuthOf(before[i])) < 1.0e-3);
            QVERIFY(std::abs(hit(i).direction.y + std::sin(0.349066f)) < 1.0e-5f);
        }
        QVERIFY(!child<NumberBox>("elevation")->differs());
        QVERIFY(child<NumberBox>("azimuth")->differs());
        // A slider may pass where no azimuth is left.
        m_session->undo();
        auto* slider = child<QSlider>("elevationSlider");
        slider->setSliderDown(true);
        for (const int degrees : {-89, -90, -40}) {
            slider->setValue(degrees);
            QVERIFY(viewport().syncNow().ok());
            QTest::qWait(20);
        }
        slider->setSliderDown(false);
        QVERIFY(std::abs(azimuthOf(hit(0)) - azimuthOf(before[0])) < 1.0e-2);
        QVERIFY(std::abs(azimuthOf(hit(1)) - azimuthOf(before[1])) < 1.0e-2);
    }

    void savedPresetsAreListedAtOnce() {
        m_session->hits().select(0);
        auto* preset = child<QComboBox>("preset");
        DeformationConstants constants;
        constants.power = 0.0321f;
        QVERIFY(m_session->settings().setConstants(constants));
        QTimer::singleShot(0, this, [] {
            auto* asked = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
            QVERIFY(asked != nullptr);
            asked->setTextValue(QStringLiteral("Mine"));
            asked->accept();
        });
        action("Save as Preset…")->trigger();
        const int mine = preset->findText(QStringLiteral("Mine"));
        QVERIFY(mine >= 0);
        QVERIFY(preset->currentIndex() != mine);
        Q_EMIT preset->activated(mine);
        QCOMPARE(hit(0).constants.power, 0.0321f);
        QCOMPARE(preset->currentText(), QStringLiteral("Mine"));
        action("Delete Preset")->trigger();
        QCOMPARE(preset->findText(QStringLiteral("Mine")), -1);
        QCOMPARE(preset->currentText(), QString());
    }

    // A unit vector's square is rounded, by more for some directions than for others.
    void everyDirectionIsAsShotFirst() {
        Hit hit = this->hit(1);
        for (int i = 1; i <= 40; ++i) {
            const auto at = static_cast<float>(i);
            hit.direction = glm::normalize(glm::vec3(std::sin(at), std::cos(1.7f * at), std::sin(0.3f * at)));
            hit.flight = glm::vec3(0.0f);
            QVERIFY(m_session->hits().add(hit).ok());
            m_session->hits().select(m_session->hits().history().size() - 1);
            QVERIFY2(child<QToolButton>("asShot")->isChecked(), qPrintable(QString::number(i)));
        }
    }

    void handlesAreDragged_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("size") << "hitSize";
        QTest::newRow("depth") << "hitDepth";
        QTest::newRow("direction") << "hitDirection";
    }
    void handlesAreDragged() {
        QFETCH(QString, name);
        m_session->hits().select(1);
        const Hit before = hit(1);
        const std::size_t hits = m_session->hits().history().size();
        const glm::vec3 eye = viewport().camera().eye();
        drag(name, 30);
        Hit after = hit(1);
        QVERIFY2(!(after == before), "nothing changed");
        if (name == QLatin1String("hitSize")) {
            QVERIFY(after.constants.maxDistance > 1.05f * before.constants.maxDistance);
            after.constants.maxDistance = before.constants.maxDistance;
        } else if (name == QLatin1String("hitDepth")) {
            QVERIFY(after.constants.maxMagnitude > 1.05f * before.constants.maxMagnitude);
            after.constants.maxMagnitude = before.constants.maxMagnitude;
        } else {
            QVERIFY(glm::dot(after.direction, before.direction) < 0.999f);
            QVERIFY(std::abs(glm::length(after.direction) - 1.0f) < 1.0e-5f);
            QVERIFY(after.flight == before.direction);
            after.direction = before.direction;
            after.flight = before.flight;
        }
        QVERIFY(after == before);  // and nothing else changed
        QCOMPARE(m_session->hits().history().size(), hits);
        QVERIFY(viewport().camera().eye() == eye);
        m_session->undo();
        QVERIFY(hit(1) == before);
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::Hit);
        // Escape takes a drag back, and the button's release does nothing more.
        drag(name, 25, true);
        QVERIFY(hit(1) == before);
        QVERIFY(m_session->steps().toUndo()->kind == SessionUndo::Kind::Hit);
    }

    void valuesAreAsPeopleWriteThem() {
        makeWindow([](Session& session) { loadMesh(session, makeUvSphere(32, 16, 0.225f)); });
        QVERIFY(m_session->simulation().hitscan(viewport().rayThrough({0.5, 0.5})));
        m_session->hits().select(0);
        QCOMPARE(child<QDoubleSpinBox>("max_magnitude")->text(), QStringLiteral("0.027 m"));
        QCOMPARE(child<QDoubleSpinBox>("max_distance")->text(), QStringLiteral("0.045 m"));
        // The point is moved by steps that are small for the target.
        const float x = hit(0).point.x;
        child<QDoubleSpinBox>("pointX")->stepUp();
        QVERIFY(hit(0).point.x > x && hit(0).point.x < x + 0.02f);
        HitHistoryModel model(*m_session);
        QCOMPARE(model.index(0, HitHistoryModel::MaxMagnitudeColumn).data().toString(),
                 QStringLiteral("0.027"));
        QVERIFY(model.csv({}).contains(QStringLiteral("0.027,")) ||
                model.csv({}).contains(QStringLiteral("0.027\n")));
    }

private:
    Viewport& viewport() { return m_window->viewport(); }
    QDockWidget* dock() { return m_window->findChild<QDockWidget*>(QStringLiteral("hit")); }
    template <class Widget>
    Widget* child(const char* name) {
        return dock()->findChild<Widget*>(QString::fromLatin1(name));
    }
    HandleGrip* grip(const QString& name) { return viewport().findChild<HandleGrip*>(name); }
    const Hit& hit(std::size_t index) const { return m_session->hits().history().hits()[index]; }
    std::size_t changed() const {
        return m_session->targets().front()->deformed.statistics().changedVertices;
    }
    QAction* action(const char* text) {
        const QList<QAction*> actions = m_window->findChildren<QAction*>();
        const auto found = std::find_if(actions.begin(), actions.end(), [text](const QAction* one) {
            return one->text() == QString::fromUtf8(text);
        });
        return found != actions.end() ? *found : nullptr;
    }
    void type(const char* name, const QString& text) {
        auto* box = child<QDoubleSpinBox>(name);
        box->setFocus();
        box->findChild<QLineEdit*>()->selectAll();
        QTest::keyClicks(box, text);
        QTest::keyClick(box, Qt::Key_Return);
    }
    /// Degrees.
    static double azimuthOf(const Hit& hit) {
        return 57.29577951308232 *
               std::atan2(static_cast<double>(hit.direction.x), static_cast<double>(hit.direction.z));
    }
    /// Outwards from the hit's point by that many pixels.
    void drag(const QString& name, int pixels, bool escape = false) {
        HandleGrip* held = grip(name);
        QTRY_VERIFY_WITH_TIMEOUT(held->isVisible(), kPatience);
        const QPointF from = viewport().mapToGlobal(held->centre());
        const QPointF middle = viewport().mapToGlobal(0.5 * (grip(QStringLiteral("hitDepth"))->centre() +
                                                             grip(QStringLiteral("hitDirection"))->centre()));
        const QPointF way = from - middle;
        const QPointF unit = way / std::max(std::hypot(way.x(), way.y()), 1.0);
        const QPointF along = name == QLatin1String("hitDirection") ? QPointF(-unit.y(), unit.x()) : unit;
        mouse(held, QEvent::MouseButtonPress, from, true);
        for (int step = 1; step <= 5; ++step) {
            mouse(held, QEvent::MouseMove, from + step / 5.0 * pixels * along, true);
        }
        if (escape) {
            QTest::keyClick(&viewport(), Qt::Key_Escape);
        }
        mouse(held, QEvent::MouseButtonRelease, from + pixels * along, false);
    }
};

HITSCOPE_TEST(HitInspectorTest, QApplication)

}  // namespace hitscope::hit_inspector_test

#include "hit_inspector_test.moc"
