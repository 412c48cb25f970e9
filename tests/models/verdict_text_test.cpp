// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of a renderer is what files and the command line say, with the locale's numbers.
#include <QLocale>
#include <QTest>

#include "models/verdict_text.h"
#include "support/test_program.h"

namespace hitscope::verdict_text_test {

class VerdictTextTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void cleanup() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void saysWhatFilesSay() {
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        for (const PipelineVerdict& verdict :
             {PipelineVerdict{{15000, 0, 0.0f}, {}}, PipelineVerdict{{15000, 1200, 0.0934f}, {}},
              PipelineVerdict{{15000, 12, 0.0f}, {}}, PipelineVerdict{{15000, 1, 0.5f}, {}},
              PipelineVerdict{{15000, 1, 0.0f}, {}}, PipelineVerdict{{}, "no such driver"}}) {
            QCOMPARE(verdictText(verdict), QString::fromStdString(describe(verdict)));
        }
        for (const PickingVerdict& verdict :
             {PickingVerdict{4096, 0, false, {}}, PickingVerdict{4096, 0, true, {}},
              PickingVerdict{4096, 1200, false, {}}, PickingVerdict{0, 0, false, "no such driver"}}) {
            QCOMPARE(verdictText(verdict), QString::fromStdString(describe(verdict)));
        }
        RendererVerdict all;
        all.pipelines[PipelineKind::Reference] = {{15000, 0, 0.0f}, {}};
        for (const PipelineTraits& traits : allPipelines()) {
            QCOMPARE(verdictText(all, traits.kind), QString::fromStdString(describe(all, traits.kind)));
        }
    }

    void oneVertexDiffers() {
        QCOMPARE(verdictText(PipelineVerdict{{2000, 1, 0.5f}, {}}),
                 QStringLiteral("not bit-exact: 1 of 2,000 vertices differs, by up to 0.5 m"));
        QCOMPARE(verdictText(PipelineVerdict{{2000, 1, 0.0f}, {}}),
                 QStringLiteral("not bit-exact: 1 of 2,000 vertices differs, in its normal only"));
    }

    void numbersAreTheLocales() {
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        QCOMPARE(verdictText(PipelineVerdict{{15000, 1200, 0.0934f}, {}}),
                 QStringLiteral("not bit-exact: 1.200 of 15.000 vertices differ, by up to 0,093 m"));
        QCOMPARE(verdictText(PickingVerdict{4096, 1200, false, {}}),
                 QStringLiteral("wrong in 1.200 of 4.096 pixels compared"));
    }
};

HITSCOPE_TEST(VerdictTextTest, QCoreApplication)

}  // namespace hitscope::verdict_text_test

#include "verdict_text_test.moc"
