// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/constants_presets.h"
#include "support/test_program.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace hitscope::constants_presets_test {

class ConstantsPresetsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oursAreValidAndDiffer() {
        const ConstantsPresets presets;
        QVERIFY(presets.all().size() >= 3);
        QVERIFY(presets.all().front().constants == DeformationConstants{});
        for (std::size_t i = 0; i < presets.all().size(); ++i) {
            QVERIFY(isValid(presets.all()[i].constants));
            QVERIFY(presets.all()[i].isOurs);
            QCOMPARE(presets.find(presets.all()[i].constants, {}), std::optional(i));
        }
    }

    /// The paper's preset is of its function alone; our others say nothing of the form.
    void thePapersIsOfItsForm() {
        const ConstantsPresets presets;
        DentForm crater;
        crater.profile = DentProfile::Crater;
        DentForm curveThatIsNotUsed;
        curveThatIsNotUsed.curve[0] = 0.5f;
        QVERIFY(!presets.find({}, crater));
        QCOMPARE(presets.find({}, curveThatIsNotUsed), std::optional<std::size_t>(0));
        QCOMPARE(presets.find(presets.all()[1].constants, crater), std::optional<std::size_t>(1));
    }

    void savedOnesHaveAForm() {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
        ConstantsPresets presets;
        const std::size_t ours = presets.all().size();
        DentForm form;
        form.profile = DentProfile::Curve;
        form.direction = DentDirection::IntoSurface;
        form.curve[1] = 0.123456789f;
        DentForm press;
        press.direction = DentDirection::Press;
        press.radius = 0.3f;  // each shot's own
        QVERIFY(presets.save(QStringLiteral("A"), {}, form).ok());
        QVERIFY(presets.save(QStringLiteral("B"), {}, press).ok());
        presets.store(settings);
        ConstantsPresets again;
        again.load(settings);
        QCOMPARE(again.find({}, form), std::optional(ours));
        press.radius = 2.0f;
        QCOMPARE(again.find({}, press), std::optional(ours + 1));
        QCOMPARE(again.find({}, {}), std::optional<std::size_t>(0));
        settings.setValue(QStringLiteral("constantsPresets/1/profile"), QStringLiteral("paprika"));
        ConstantsPresets fewer;
        fewer.load(settings);
        QCOMPARE(fewer.all().size(), again.all().size() - 1);
    }

    void savedOnesComeBack() {
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
        ConstantsPresets presets;
        const std::size_t ours = presets.all().size();
        const DeformationConstants dent{0.123456789f, 0.01f, 0.2f};
        QVERIFY(presets.save(QStringLiteral(" Mine "), dent, {}).ok());
        QVERIFY(presets.save(QStringLiteral("Another"), {0.3f, 0.02f, 0.2f}, {}).ok());
        QVERIFY(presets.save(QStringLiteral("mine"), dent, {}).ok());
        QCOMPARE(presets.all().size(), ours + 2);
        QCOMPARE(presets.all()[ours].name, QStringLiteral("Another"));
        presets.store(settings);

        ConstantsPresets again;
        again.load(settings);
        QCOMPARE(again.all().size(), ours + 2);
        QCOMPARE(again.find(dent, {}), std::optional(ours + 1));
        again.remove(QStringLiteral("Mine"));
        again.remove(again.all()[0].name);
        QCOMPARE(again.all().size(), ours + 1);
        again.store(settings);
        ConstantsPresets fewer;
        fewer.load(settings);
        QCOMPARE(fewer.all().size(), ours + 1);
    }

    void whatCannotBeIsRefused() {
        ConstantsPresets presets;
        QVERIFY(!presets.save(QStringLiteral("  "), {}, {}).ok());
        QVERIFY(!presets.save(QStringLiteral("paper"), {}, {}).ok());
        const QTemporaryDir folder;
        QSettings settings(folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat);
        settings.beginWriteArray(QStringLiteral("constantsPresets"), 1);
        settings.setArrayIndex(0);
        settings.setValue(QStringLiteral("name"), QStringLiteral("broken"));
        settings.setValue(QStringLiteral("max_distance"), QStringLiteral("nan"));
        settings.endArray();
        const std::size_t ours = presets.all().size();
        presets.load(settings);
        QCOMPARE(presets.all().size(), ours);
    }
};

HITSCOPE_TEST(ConstantsPresetsTest, QCoreApplication)

}  // namespace hitscope::constants_presets_test

#include "constants_presets_test.moc"
