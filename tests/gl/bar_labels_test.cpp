// SPDX-License-Identifier: GPL-3.0-or-later
// What stands beside the colour bar, for ranges of any size.
#include "scene/bar_labels.h"

#include <QTest>
#include <algorithm>
#include <set>

#include "support/test_program.h"

namespace hitscope::bar_labels_test {

class BarLabelsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void labelsAreTheirValues_data() {
        QTest::addColumn<float>("low");
        QTest::addColumn<float>("high");
        for (const float high : {3.0e-12f, 5.3e-8f, 2.0e-7f, 4.7e-6f, 1.0e-5f, 3.3e-5f, 0.1f, 0.3f, 45.0f}) {
            QTest::addRow("to %g", static_cast<double>(high)) << 0.0f << high;
            QTest::addRow("about 0, %g", static_cast<double>(high)) << -high << high;
        }
        QTest::newRow("far from 0") << 1.0f << 1.00001f;
    }
    void labelsAreTheirValues() {
        QFETCH(const float, low);
        QFETCH(const float, high);
        const double span = static_cast<double>(high) - static_cast<double>(low);
        const std::vector<BarLabel> labels = barLabels({.range = {low, high}}, 0.05);
        QVERIFY(labels.size() > 3);
        std::set<QString> texts;
        for (const BarLabel& label : labels) {
            QVERIFY2(std::abs(label.text.toDouble() - label.value) < 0.05 * span, qPrintable(label.text));
            QVERIFY2(texts.insert(label.text).second, qPrintable(label.text));
        }
        const auto hasExponent = [](const BarLabel& label) { return label.text.contains(u'e'); };
        QVERIFY(
            std::all_of(labels.begin(), labels.end(),
                        [&](const BarLabel& label) { return label.value == 0.0 || hasExponent(label); }) ||
            std::none_of(labels.begin(), labels.end(), hasExponent));
    }

    void usualRangesHaveFixedDecimals() {
        const std::vector<BarLabel> labels = barLabels({.range = {0.0f, 0.5f}}, 0.05);
        QCOMPARE(labels[0].text, QStringLiteral("0.00"));
        QCOMPARE(labels[1].text, QStringLiteral("0.50"));
        QCOMPARE(labels[2].text, QStringLiteral("0.1"));
    }
};

HITSCOPE_TEST(BarLabelsTest, QCoreApplication)

}  // namespace hitscope::bar_labels_test

#include "bar_labels_test.moc"
