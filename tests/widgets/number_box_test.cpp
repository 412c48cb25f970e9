// SPDX-License-Identifier: GPL-3.0-or-later
// What may be typed into the number fields of the panels, and what they show.
#include "panels/fields/number_box.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <cmath>
#include <memory>

#include "session/shown_number.h"
#include "support/test_program.h"
#include "widgets/window_support.h"

namespace hitscope::number_box_test {

class NumberBoxTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() {
        m_window = std::make_unique<QWidget>();
        auto* row = new QHBoxLayout(m_window.get());
        m_other = new QLineEdit;
        m_box = new NumberBox;
        m_box->setRange(0.0, 1000.0);
        m_box->setSuffix(QStringLiteral(" m"));
        m_box->showNumber(0.5);
        row->addWidget(m_other);
        row->addWidget(m_box);
        m_window->show();
        makeActive(*m_window);
        m_other->setFocus();
    }

    /// Where it stood for several, the number that is typed or stepped to is shown at once.
    void typedForSeveral() {
        m_box->showDiffering();
        m_box->setFocus();
        m_box->selectAll();
        QTest::keyClicks(m_box, QStringLiteral("0.25"));
        m_box->interpretText();
        QVERIFY(!m_box->differs());
        QCOMPARE(m_box->text(), QStringLiteral("0.25 m"));
        m_box->showDiffering();
        m_box->stepUp();
        QVERIFY(m_box->text() != QStringLiteral("0.25 m"));
        QVERIFY(!m_box->text().startsWith(QStringLiteral("differ")));
    }

    void takesWhatPeopleType_data() {
        QTest::addColumn<QString>("typed");
        QTest::addColumn<double>("metres");
        const auto row = [](const char* typed, double metres) {
            QTest::newRow(typed) << QString::fromUtf8(typed) << metres;
        };
        row("0.3", 0.3);
        row("0,3", 0.3);
        row("3e-4", 3e-4);
        row("30cm", 0.3);
        row("30 cm", 0.3);
        row("0,4 mm", 4e-4);
        row("250 um", 2.5e-4);
        row("1km", 1000.0);
        row("7m", 7.0);
        row("7 m", 7.0);
    }
    void takesWhatPeopleType() {
        QFETCH(QString, typed);
        QFETCH(double, metres);
        type(typed);
        QVERIFY2(std::abs(m_box->value() - metres) < 1e-9, qPrintable(m_box->text()));
    }

    void leavesWhatItDoesNotUnderstand_data() {
        QTest::addColumn<QString>("typed");
        for (const char* const typed : {"0.3x", "1.234,5", "nan", "1e400", "-1", "2000", "3 kg", "", "m"}) {
            QTest::newRow(typed) << QString::fromUtf8(typed);
        }
    }
    void leavesWhatItDoesNotUnderstand() {
        QFETCH(QString, typed);
        const QSignalSpy edited(m_box, &NumberBox::edited);
        type(typed);
        QCOMPARE(m_box->value(), 0.5);
        QCOMPARE(m_box->text(), QStringLiteral("0.5 m"));
        QCOMPARE(edited.count(), 0);
    }

    void saysWhichUnitsItTakes() {
        type(QStringLiteral("2 in"));
        QTRY_VERIFY_WITH_TIMEOUT(QToolTip::text().contains(QStringLiteral("mm")), kPatience);
        m_box->setSuffix(QStringLiteral(" kg"));
        type(QStringLiteral("3 in"));
        QTRY_VERIFY_WITH_TIMEOUT(QToolTip::text().contains(QStringLiteral("“3 in”")), kPatience);
        QVERIFY(!QToolTip::text().contains(QStringLiteral("mm")));
        QToolTip::hideText();
    }

    /// To a thousandth of its step; looking at it changes nothing.
    void isShownToItsStep() {
        m_box->setRange(-1000.0, 1000.0);
        m_box->setStepsWithin(3.0);
        const double value = static_cast<double>(1.8072712f);
        m_box->showNumber(value);
        QCOMPARE(m_box->text(), QStringLiteral("1.8073 m"));
        const QSignalSpy edited(m_box, &NumberBox::edited);
        m_box->setFocus();
        QCOMPARE(m_box->text(), QStringLiteral("1.8072712 m"));
        QTest::keyClick(m_box, Qt::Key_Return);
        m_other->setFocus();
        QCOMPARE(m_box->text(), QStringLiteral("1.8073 m"));
        QCOMPARE(m_box->value(), value);
        QCOMPARE(edited.size(), 0);
        m_box->showNumber(-8.82e-5);
        QCOMPARE(m_box->text(), QStringLiteral("-0.0001 m"));
        m_box->showNumber(-1.0e-6);
        QCOMPARE(m_box->text(), QStringLiteral("0 m"));
    }

    void isShownRoundedAndEditedInFull() {
        const double number = static_cast<double>(0.00025362736f);
        m_box->showNumber(number);
        QVERIFY2(m_box->text().size() <= 12 && m_box->text().startsWith(QStringLiteral("0.00025")),
                 qPrintable(m_box->text()));
        const QSignalSpy edited(m_box, &NumberBox::edited);
        m_box->setFocus();
        QCOMPARE(m_box->text(), shownFloat(0.00025362736f) + QStringLiteral(" m"));
        m_other->setFocus();
        QVERIFY(m_box->text().size() <= 12);
        QCOMPARE(m_box->value(), number);
        QCOMPARE(edited.count(), 0);
    }

    void stepsWithinASpan() {
        m_box->setStepsWithin(0.0008);
        m_box->showNumber(0.0);
        m_box->stepBy(3);
        QVERIFY2(std::abs(m_box->value() - 3e-5) < 1e-12, qPrintable(m_box->text()));
        m_box->stepBy(-3);
        QCOMPARE(m_box->value(), 0.0);
    }

    /// The target that it is about moves, and turns.
    void keepsWhatIsTypedMeanwhile() {
        m_box->showNumber(185.59);
        m_box->setFocus();
        m_box->selectAll();
        double lower = 185.0;
        for (const char key : {'1', '5', '0'}) {
            QTest::keyClick(m_box, key);
            m_box->setStepsWithin(lower);
            m_box->showNumber(lower);
            lower /= 10.0;
        }
        QTest::keyClick(m_box, Qt::Key_Tab);
        QCOMPARE(m_box->value(), 150.0);
    }

    /// A click there, or the End key, is the end of the number.
    void nothingIsTypedBehindTheUnit() {
        m_box->showNumber(2.0);
        m_box->setFocus();
        QTest::keyClick(m_box, Qt::Key_End);
        QTest::keyClick(m_box, '5');
        QTest::keyClick(m_box, Qt::Key_Return);
        QVERIFY2(m_box->value() == 25.0, qPrintable(m_box->text()));
    }

private:
    void type(const QString& text) {
        m_box->setFocus();
        m_box->selectAll();
        QTest::keyClick(m_box, Qt::Key_Delete);
        QTest::keyClicks(m_box, text);
        QTest::keyClick(m_box, Qt::Key_Return);
        m_other->setFocus();
    }

    std::unique_ptr<QWidget> m_window;
    QLineEdit* m_other = nullptr;
    NumberBox* m_box = nullptr;
};

HITSCOPE_TEST(NumberBoxTest, QApplication)

}  // namespace hitscope::number_box_test

#include "number_box_test.moc"
