// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/projectile_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include "app/settings/app_settings.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::projectile_dialog_test {

namespace {

/// In the order of projectileParameters().
constexpr const char* kFields[] = {"speed",     "radius",           "mass",   "lifetime", "rateOfFire",
                                   "mostAlive", "referenceImpulse", "gravity"};

}  // namespace

/// What the dialog shows is what is shot, with the ranges that the physics keeps to.
class ProjectileDialogTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyNumberHasItsRange() {
        Session session;
        ProjectileDialog dialog(session);
        QCOMPARE(std::size(kFields), projectileParameters().size());
        for (std::size_t i = 0; i < std::size(kFields); ++i) {
            const ParameterDescriptor& parameter = projectileParameters()[i];
            const auto* box = dialog.findChild<QDoubleSpinBox*>(kFields[i]);
            QVERIFY(box != nullptr);
            QCOMPARE(box->minimum(), parameter.minimum);
            QCOMPARE(box->maximum(), parameter.maximum);
            QVERIFY(std::abs(box->value() - parameter.defaultValue) < 1e-3);
            QVERIFY(!box->toolTip().isEmpty());
        }
    }

    void whatIsTypedIsShot() {
        Session session;
        ProjectileDialog dialog(session);
        for (std::size_t i = 0; i < std::size(kFields); ++i) {
            auto* box = dialog.findChild<QDoubleSpinBox*>(kFields[i]);
            box->setEnabled(true);
            const double wanted = box->value() + 2.0 * box->singleStep();
            box->setFocus();
            box->selectAll();
            QTest::keyClicks(box, box->locale().toString(wanted, 'f', box->decimals()));
            QTest::keyClick(box, Qt::Key_Enter);
            QVERIFY2(std::abs(parameterValue(session.settings().projectile(), i) - wanted) < 1e-3,
                     kFields[i]);
        }
        auto* follows = dialog.findChild<QCheckBox*>("powerFollowsImpulse");
        auto* reference = dialog.findChild<QDoubleSpinBox*>("referenceImpulse");
        QVERIFY(!follows->isChecked());
        follows->click();
        QVERIFY(session.settings().projectile().powerFollowsImpulse);
        QVERIFY(reference->isEnabled());
        dialog.findChild<QCheckBox*>("bounces")->click();
        QVERIFY(session.settings().projectile().bouncesCount);
        dialog.findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::RestoreDefaults)->click();
        QVERIFY(session.settings().projectile() == ProjectileSettings{});
        QVERIFY(!follows->isChecked() && !reference->isEnabled());
    }

    void showsWhatIsSetElsewhere() {
        Session session;
        ProjectileDialog dialog(session);
        QSignalSpy changed(&session.settings(), &SessionSettings::projectileChanged);
        ProjectileSettings settings;
        settings.speed = 77.0f;
        settings.mostAlive = 2000;
        session.settings().setProjectile(settings);
        QCOMPARE(dialog.findChild<QDoubleSpinBox*>("speed")->value(), 77.0);
        QCOMPARE(dialog.findChild<QDoubleSpinBox*>("mostAlive")->value(), 2000.0);
        // Showing is not setting.
        QCOMPARE(changed.count(), 1);
    }

    void aColourIsOneStepOrNone() {
        Session session;
        ProjectileDialog dialog(session);
        const ProjectileSettings before = session.settings().projectile();
        auto* button = dialog.findChild<QToolButton*>("colour");
        button->click();
        auto* colours = button->findChild<QColorDialog*>();
        QVERIFY(colours != nullptr);
        QVERIFY2(colours->windowTitle().contains("rojectile"), qPrintable(colours->windowTitle()));
        colours->setCurrentColor(Qt::red);
        QCOMPARE(session.settings().projectile().colour, glm::vec3(1.0f, 0.0f, 0.0f));
        colours->reject();
        QVERIFY(session.settings().projectile() == before);
        QVERIFY(!session.steps().canUndo());
        QTRY_VERIFY_WITH_TIMEOUT(button->findChild<QColorDialog*>() == nullptr, kPatience);
        button->click();
        colours = button->findChild<QColorDialog*>();
        colours->setCurrentColor(Qt::red);
        colours->setCurrentColor(Qt::blue);
        colours->accept();
        QCOMPARE(session.settings().projectile().colour, glm::vec3(0.0f, 0.0f, 1.0f));
        session.undo();
        QVERIFY(session.settings().projectile() == before);
        QVERIFY(!session.steps().canUndo());
    }

    void settingsAreKept() {
        TestSettings kept;
        ProjectileSettings settings;
        settings.speed = 123.0f;
        settings.mostAlive = 17;
        settings.rateOfFire = 3.0f;
        settings.powerFollowsImpulse = true;
        {
            Session session;
            session.settings().setProjectile(settings);
            QSettings values;
            saveSessionSettings(values, session);
        }
        Session session;
        loadSessionSettings(QSettings(), session);
        QVERIFY(session.settings().projectile() == settings);
    }
};

HITSCOPE_TEST(ProjectileDialogTest, QApplication)

}  // namespace hitscope::projectile_dialog_test

#include "projectile_dialog_test.moc"
