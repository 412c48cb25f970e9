// SPDX-License-Identifier: GPL-3.0-or-later
// The benchmarks' harness on a clock of its own: order, warm-up, budget, figures.
#include <QTest>

#include "cli/bench/harness.h"
#include "support/test_program.h"

namespace hitscope::bench_harness_test {

using namespace bench;

namespace {

Samples samplesOf(std::initializer_list<double> values) {
    Samples samples;
    for (const double value : values) {
        samples.add(value);
    }
    return samples;
}

/// A clock that stands still but for what the variants take, and who ran when.
struct FakeWorld {
    double now = 0.0;
    QString order;

    Variant variant(const char* name, double seconds, double preparation = 0.0) {
        Variant made;
        made.name = name;
        made.prepare = [this, preparation]() -> Status {
            now += preparation;
            return Done{};
        };
        made.run = [this, name, seconds]() -> Status {
            now += seconds;
            order += QLatin1String(name);
            return Done{};
        };
        return made;
    }

    std::vector<Samples> measure(const std::vector<Variant>& variants, const Plan& plan) {
        Result<std::vector<Samples>> samples = bench::measure(variants, plan, {}, [this] { return now; });
        return samples ? samples.value() : std::vector<Samples>();
    }
};

}  // namespace

class BenchHarnessTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void variantsTakeTurns() {
        FakeWorld world;
        const Plan plan{.warmUp = 0, .leastSamples = 1, .mostSamples = 3, .seconds = 100.0};
        const std::vector<Samples> samples =
            world.measure({world.variant("A", 1.0), world.variant("B", 2.0), world.variant("C", 3.0)}, plan);
        QCOMPARE(world.order, QStringLiteral("ABCCBAABC"));
        QCOMPARE(samples.size(), std::size_t{3});
        QCOMPARE(samples[2].size(), std::size_t{3});
        QCOMPARE(samples[1].median(), 2.0);
    }

    void warmUpIsNotKept() {
        FakeWorld world;
        int runs = 0;
        Variant slowAtFirst;
        slowAtFirst.name = "A";
        slowAtFirst.run = [&]() -> Status {
            world.now += runs++ < 2 ? 9.0 : 1.0;
            return Done{};
        };
        const Plan plan{.warmUp = 2, .leastSamples = 3, .mostSamples = 5, .seconds = 100.0};
        const std::vector<Samples> samples = world.measure({slowAtFirst}, plan);
        QCOMPARE(runs, 7);
        QCOMPARE(samples[0].size(), std::size_t{5});
        QCOMPARE(samples[0].most(), 1.0);
    }

    void warmUpThatEatsTheBudgetIsCutShort() {
        FakeWorld world;
        const Plan plan{.warmUp = 5, .leastSamples = 2, .mostSamples = 2, .seconds = 4.0};
        static_cast<void>(world.measure({world.variant("A", 10.0), world.variant("B", 0.5)}, plan));
        QCOMPARE(world.order.count(QLatin1Char('A')), 1 + 2);
        QCOMPARE(world.order.count(QLatin1Char('B')), 5 + 2);
    }

    void slowVariantsGetFewerSamples() {
        FakeWorld world;
        const Plan plan{.warmUp = 0, .leastSamples = 3, .mostSamples = 50, .seconds = 10.0};
        const std::vector<Samples> samples = world.measure(
            {world.variant("A", 100.0), world.variant("B", 1.0), world.variant("C", 0.01)}, plan);
        QCOMPARE(samples[0].size(), std::size_t{3});   // the least, whatever it costs
        QCOMPARE(samples[1].size(), std::size_t{10});  // the budget
        QCOMPARE(samples[2].size(), std::size_t{50});  // the most
    }

    void preparationCountsForTheBudgetOnly() {
        FakeWorld world;
        const Plan plan{.warmUp = 0, .leastSamples = 1, .mostSamples = 50, .seconds = 10.0};
        const std::vector<Samples> samples = world.measure({world.variant("A", 1.0, 4.0)}, plan);
        QCOMPARE(samples[0].size(), std::size_t{2});
        QCOMPARE(samples[0].median(), 1.0);
    }

    void timesAreAUnit() {
        FakeWorld world;
        Variant block = world.variant("A", 5.0);
        block.units = 10.0;
        const std::vector<Samples> samples = world.measure({block}, {.warmUp = 0, .mostSamples = 3});
        QCOMPARE(samples[0].median(), 0.5);
    }

    void anErrorEndsIt() {
        FakeWorld world;
        Variant broken = world.variant("A", 1.0);
        broken.prepare = []() -> Status { return Error{"Broken.", "", ""}; };
        const std::vector<Variant> variants{world.variant("B", 1.0), broken};
        const Result<std::vector<Samples>> samples =
            bench::measure(variants, Plan(), {}, [&] { return world.now; });
        QVERIFY(!samples);
        QCOMPARE(samples.error().what, std::string("Broken."));
        QCOMPARE(world.order, QStringLiteral("B"));
    }

    void medianAndRange() {
        const Samples odd = samplesOf({5.0, 1.0, 9.0});
        QCOMPARE(odd.median(), 5.0);
        QCOMPARE(odd.least(), 1.0);
        QCOMPARE(odd.most(), 9.0);
        QCOMPARE(samplesOf({4.0, 1.0, 2.0, 8.0}).median(), 3.0);
        QCOMPARE(Samples().median(), 0.0);
        QCOMPARE(Samples().most(), 0.0);
    }

    /// A machine that gets slower and slower does it to both.
    void driftCancelsInRatios() {
        const Samples a = samplesOf({2.0, 6.0, 40.0});
        const Samples b = samplesOf({1.0, 2.0, 20.0});
        QCOMPARE(timeRatio(a, b), 2.0);
        QCOMPARE(ratioOfMedians(a, samplesOf({1.0, 3.0})), 3.0);  // 6 / 2
        for (const auto ratio : {timeRatio, ratioOfMedians}) {
            QCOMPARE(ratio(a, Samples()), 0.0);
            QCOMPARE(ratio(Samples(), Samples()), 0.0);
        }
    }

    /// The slow one dropped out when its budget was spent. The machine was slow in the rounds after that,
    /// which say nothing of the two.
    void roundsThatBothWereInCount() {
        const Samples slow = samplesOf({4.0, 8.0, 12.0, 20.0, 16.0});
        const Samples fast = samplesOf({1.0, 2.0, 3.0, 5.0, 4.0, 50.0, 60.0, 70.0, 80.0, 90.0, 90.0});
        const TimeRatio ratio = timeRatioWithRounds(slow, fast);
        QCOMPARE(ratio.value, 4.0);
        QCOMPARE(ratio.rounds.size(), std::size_t{5});  // enough for an interval of bench compare
        QCOMPARE(timeRatio(fast, slow), 0.25);
    }
};

HITSCOPE_TEST(BenchHarnessTest, QCoreApplication)

}  // namespace hitscope::bench_harness_test

#include "bench_harness_test.moc"
