// SPDX-License-Identifier: GPL-3.0-or-later
// The form of the next dent in the Constants dock: its boxes, and the free curve under mouse and keys.
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>

#include "panels/deformation_constants/deformation_constants_panel.h"
#include "panels/deformation_constants/falloff_plot.h"
#include "panels/deformation_constants/form_fields.h"
#include "panels/help/help_text.h"
#include "panels/plot/custom_plot.h"
#include "session/session_undo.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::dent_form_boxes_test {

class DentFormBoxesTest : public QObject, protected WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void init();
    void cleanup() { dropWindow(); }
    void boxesSetTheForm();
    void pressNamesItsReason();
    void curveIsDragged();
    void curveMovesByKeys();
    void shotsTakeTheForm();

private:
    [[nodiscard]] QComboBox& box(const char* name) const {
        return *m_dock->findChild<QComboBox*>(QLatin1String(name));
    }
    [[nodiscard]] const DentForm& form() const { return m_session->settings().constantsSetting().form; }
    void choose(const char* name, int index);
    /// Where a point of the curve is, in the plot's own pixels.
    [[nodiscard]] QPoint place(int point, double ordinate) const;

    QDockWidget* m_dock = nullptr;
    FalloffPlot* m_plot = nullptr;
    QCustomPlot* m_drawn = nullptr;
};

void DentFormBoxesTest::init() {
    makeWindow();
    // The dock of a hit has such boxes too.
    auto* panel = m_window->findChild<DeformationConstantsPanel*>();
    QVERIFY(panel != nullptr);
    m_plot = panel->findChild<FalloffPlot*>();
    QVERIFY(m_plot != nullptr);
    m_drawn = m_plot->findChild<QCustomPlot*>();
    m_dock = nullptr;
    for (QDockWidget* dock : m_window->findChildren<QDockWidget*>()) {
        m_dock = dock->isAncestorOf(m_plot) ? dock : m_dock;
    }
    QVERIFY(m_dock != nullptr && m_drawn != nullptr);
    m_dock->show();
    m_dock->raise();
    QTRY_VERIFY_WITH_TIMEOUT(m_drawn->isVisible() && m_drawn->width() > 100, kPatience);
}

/// By the keyboard, as a person does: the box says what was chosen, not what it was set to.
void DentFormBoxesTest::choose(const char* name, int index) {
    makeActive(*m_window);
    QComboBox& chosen = box(name);
    chosen.setFocus();
    for (int i = chosen.count(); i > 0; --i) {
        QTest::keyClick(&chosen, Qt::Key_Up);
    }
    for (int i = 0; i < index; ++i) {
        QTest::keyClick(&chosen, Qt::Key_Down);
    }
    QCOMPARE(chosen.currentIndex(), index);
}

QPoint DentFormBoxesTest::place(int point, double ordinate) const {
    const double rim = m_drawn->xAxis->range().upper / 1.25;
    const double top = m_drawn->yAxis->range().upper / 1.35;
    return {static_cast<int>(std::lround(
                m_drawn->xAxis->coordToPixel(rim * point / static_cast<double>(kCurvePoints - 1)))),
            static_cast<int>(std::lround(m_drawn->yAxis->coordToPixel(top * ordinate)))};
}

void DentFormBoxesTest::boxesSetTheForm() {
    for (int i = static_cast<int>(kDentProfileKeys.size()) - 1; i >= 0; --i) {
        choose("profile", i);
        QCOMPARE(static_cast<int>(form().profile), i);
    }
    for (int i = static_cast<int>(kDentDirectionKeys.size()) - 1; i >= 0; --i) {
        choose("dentDirection", i);
        QCOMPARE(static_cast<int>(form().direction), i);
    }
}

void DentFormBoxesTest::pressNamesItsReason() {
    choose("dentDirection", static_cast<int>(DentDirection::Press));
    QVERIFY(!box("profile").isEnabled());
    QCOMPARE(whyDisabled(box("profile")), QStringLiteral("A press has the shape of the projectile."));
    choose("dentDirection", 0);
    QVERIFY(box("profile").isEnabled());
}

void DentFormBoxesTest::curveIsDragged() {
    choose("profile", static_cast<int>(DentProfile::Curve));
    const CurveOrdinates before = form().curve;
    const QPoint from = place(3, static_cast<double>(before[3]));
    const QPoint to = place(3, 0.25);
    const std::size_t steps = m_session->steps().size();
    QTest::mousePress(m_drawn, Qt::LeftButton, {}, from);
    QTest::mouseMove(m_drawn, (from + to) / 2);
    QTest::mouseMove(m_drawn, to);
    QTest::mouseRelease(m_drawn, Qt::LeftButton, {}, to);
    QVERIFY2(std::abs(form().curve[3] - 0.25f) < 0.03f, qPrintable(QString::number(form().curve[3])));
    for (std::size_t i = 0; i < kCurvePoints; ++i) {
        QVERIFY(i == 3 || form().curve[i] == before[i]);
    }
    // A drag is one step to undo, where it is one at all.
    QVERIFY(m_session->steps().size() <= steps + 1);
    const CurveOrdinates dragged = form().curve;
    QTest::mousePress(m_drawn, Qt::LeftButton, {}, to);
    QTest::mouseMove(m_drawn, from);
    QVERIFY(form().curve != dragged);
    QTest::keyClick(m_plot, Qt::Key_Escape);
    QCOMPARE(form().curve, dragged);
    QTest::mouseMove(m_drawn, (from + to) / 2);
    QTest::mouseRelease(m_drawn, Qt::LeftButton, {}, from);
    QCOMPARE(form().curve, dragged);
}

void DentFormBoxesTest::curveMovesByKeys() {
    choose("profile", static_cast<int>(DentProfile::Curve));
    makeActive(*m_window);
    m_plot->setFocus();
    const CurveOrdinates before = form().curve;
    QTest::keyClick(m_plot, Qt::Key_Right);
    QTest::keyClick(m_plot, Qt::Key_Right);
    QTest::keyClick(m_plot, Qt::Key_Down);
    QVERIFY(std::abs(form().curve[2] - (before[2] - 0.05f)) < 1.0e-3f);
    QTest::keyClick(m_plot, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(std::abs(form().curve[2] - (before[2] - 0.04f)) < 1.0e-3f);
    for (int i = 0; i < 60; ++i) {
        QTest::keyClick(m_plot, Qt::Key_Up);
    }
    QCOMPARE(form().curve[2], 1.0f);  // the cap
    QTest::keyClick(m_plot, Qt::Key_Left);
    QTest::keyClick(m_plot, Qt::Key_Down);
    QVERIFY(form().curve[1] < before[1]);
    // Of any other profile there is nothing to move.
    choose("profile", 0);
    m_plot->setFocus();
    QTest::keyClick(m_plot, Qt::Key_Down);
    QCOMPARE(static_cast<int>(form().profile), 0);
}

void DentFormBoxesTest::shotsTakeTheForm() {
    choose("profile", static_cast<int>(DentProfile::Crater));
    m_session->settings().setFlightMode(FlightMode::Instant);
    QTest::mouseClick(&m_window->viewport(), Qt::LeftButton, {}, m_window->viewport().rect().center());
    QTRY_COMPARE_WITH_TIMEOUT(m_session->hits().history().size(), std::size_t(1), kPatience);
    QCOMPARE(m_session->hits().history().hits()[0].form.profile, DentProfile::Crater);
}

HITSCOPE_TEST(DentFormBoxesTest, QApplication)

}  // namespace hitscope::dent_form_boxes_test

#include "dent_form_boxes_test.moc"
