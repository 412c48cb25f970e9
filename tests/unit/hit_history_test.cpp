// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <random>

#include "deform/hit_history.h"
#include "support/test_program.h"

namespace hitscope::hit_history_test {

namespace {

using Rows = std::vector<std::size_t>;

Hit hitOn(std::uint32_t target, float x = 0.0f) {
    Hit hit;
    hit.target = {target};
    hit.point.x = x;
    return hit;
}

/// Hits at x = 0, 1, 2 ...
HitHistory historyOf(std::size_t hits) {
    HitHistory history;
    for (std::size_t i = 0; i < hits; ++i) {
        history.append(hitOn(1, static_cast<float>(i)));
    }
    return history;
}

std::vector<Hit> hitsOf(const HitHistory& history) {
    return {history.hits().begin(), history.hits().end()};
}

QString orderOf(const HitHistory& history) {
    QString order;
    for (const Hit& hit : history.hits()) {
        order += QString::number(static_cast<int>(hit.point.x));
    }
    return order;
}

/// Every other of `size` rows: as many runs of neighbours as there can be.
Rows everyOther(std::size_t size) {
    Rows rows;
    for (std::size_t row = 1; row < size; row += 2) {
        rows.push_back(row);
    }
    return rows;
}

/// What `edits` made of `before`, as one that follows sees it.
std::vector<Hit> followed(const std::vector<Hit>& before, const std::vector<HistoryEdit>& edits) {
    HitHistory follower;
    follower.append(before);
    for (const HistoryEdit& edit : edits) {
        follower.redo(edit);
    }
    return hitsOf(follower);
}

/// The same, the plain way: the chosen hits out, and all of them in before the one that was at `to`.
std::vector<Hit> moved(const std::vector<Hit>& hits, const Rows& rows, std::size_t to) {
    std::vector<Hit> above;
    std::vector<Hit> chosen;
    std::vector<Hit> below;
    for (std::size_t row = 0; row < hits.size(); ++row) {
        const bool isChosen = std::binary_search(rows.begin(), rows.end(), row);
        (isChosen ? chosen : row < to ? above : below).push_back(hits[row]);
    }
    above.insert(above.end(), chosen.begin(), chosen.end());
    above.insert(above.end(), below.begin(), below.end());
    return above;
}

}  // namespace

class HitHistoryTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void everyChangeIsAnEditWithItsInverse() {
        HitHistory history;
        std::vector<std::vector<Hit>> states;
        std::vector<HistoryEdit> edits;
        const auto now = [&history] { return hitsOf(history); };
        states.push_back(now());
        const auto made = [&](HistoryEdit edit) {
            edits.push_back(std::move(edit));
            states.push_back(now());
        };
        for (std::uint32_t i = 0; i < 6; ++i) {
            made(history.append(hitOn(1 + i % 2, static_cast<float>(i))));
        }
        QCOMPARE(history.hits()[1].target.value, 2u);
        made(history.remove(Rows{1}).front());
        QCOMPARE(history.hits()[1].point.x, 2.0f);
        made(history.setEnabled(Rows{2}, false).front());
        QVERIFY(!history.hits()[2].enabled);
        Hit stronger = history.hits()[0];
        stronger.constants.power = 0.2f;
        made(history.replace(Rows{0}, {&stronger, 1}).front());
        QCOMPARE(history.hits()[0].constants.power, 0.2f);
        made(history.splice(0, 3, {}));
        QCOMPARE(history.size(), std::size_t{2});
        const std::vector<Hit> other = {hitOn(3), history.hits()[0], hitOn(4)};
        made(history.splice(0, 2, other));
        QCOMPARE(now(), other);
        made(history.clear());
        QCOMPARE(history.size(), std::size_t{0});
        QCOMPARE(history.revision(), edits.size());

        for (std::size_t i = edits.size(); i-- > 0;) {
            history.redo({edits[i].first, edits[i].after, edits[i].before});
            QCOMPARE(now(), states[i]);
        }
        for (std::size_t i = 0; i < edits.size(); ++i) {
            history.redo(edits[i]);
            QCOMPARE(now(), states[i + 1]);
        }
    }

    void whatDoesNotChangeIsNoEdit() {
        HitHistory history;
        history.append(hitOn(1, 0.0f));
        history.append(hitOn(2, 1.0f));
        const std::uint64_t revision = history.revision();
        const std::vector<Hit> same = hitsOf(history);
        QVERIFY(history.remove(Rows{77}).empty());
        QVERIFY(history.setEnabled(Rows{0, 1}, true).empty());
        QVERIFY(history.replace(Rows{0, 1}, same).empty());
        QVERIFY(history.move(Rows{0}, 1).empty());
        QCOMPARE(history.revision(), revision);
        const std::vector<Hit> hits = {history.hits()[0], hitOn(3), history.hits()[1]};
        const HistoryEdit edit = history.splice(0, 2, hits);
        QCOMPARE(edit.first, std::size_t{1});
        QVERIFY(edit.before.empty());
        QCOMPARE(edit.after.size(), std::size_t{1});
    }

    void followersSeeEveryEditOrStartOver() {
        HitHistory history;
        HitHistory follower;
        std::uint64_t seen = 0;
        std::mt19937 random(5);
        std::size_t startedOver = 0;
        for (int frame = 0; frame < 200; ++frame) {
            const int changes = frame == 150 ? 3000 : 3;
            for (int i = 0; i < changes; ++i) {
                if (history.size() > 5 && random() % 3 == 0) {
                    history.move(Rows{random() % history.size()}, random() % history.size());
                } else {
                    history.append(hitOn(1, static_cast<float>(random() % 1000)));
                }
            }
            if (const auto edits = history.editsSince(seen)) {
                for (const HistoryEdit& edit : *edits) {
                    follower.redo(edit);
                }
            } else {
                follower.splice(0, follower.size(), history.hits());
                ++startedOver;
            }
            seen = history.revision();
            QVERIFY(std::equal(history.hits().begin(), history.hits().end(), follower.hits().begin(),
                               follower.hits().end()));
        }
        QCOMPARE(startedOver, std::size_t{1});
    }

    void disabledHitsAreOnNoTarget() {
        HitHistory history;
        history.append(hitOn(1, 0.0f));
        history.append(hitOn(1, 1.0f));
        history.append(hitOn(2, 2.0f));
        history.setEnabled(Rows{0}, false);
        const std::vector<Hit> hits = history.hitsOn({1});
        QCOMPARE(hits.size(), std::size_t{1});
        QCOMPARE(hits[0].point.x, 1.0f);
    }

    void rowsAreThoseOfTheHistoryInOrder() {
        const HitHistory history = historyOf(5);
        QCOMPARE(history.rows(Rows{4, 9, 0, 4, 5}), (Rows{0, 4}));
        QVERIFY(history.rows({}).empty());
    }

    void movingPutsHitsTogether_data() {
        QTest::addColumn<Rows>("rows");
        QTest::addColumn<std::size_t>("to");
        QTest::addColumn<QString>("order");
        QTest::newRow("down") << Rows{1} << std::size_t{4} << "023145";
        QTest::newRow("up") << Rows{3} << std::size_t{0} << "301245";
        QTest::newRow("to the end") << Rows{0} << std::size_t{6} << "123450";
        QTest::newRow("where it is") << Rows{2} << std::size_t{2} << "012345";
        QTest::newRow("behind itself") << Rows{2} << std::size_t{3} << "012345";
        QTest::newRow("two apart, between") << Rows{4, 0} << std::size_t{3} << "120435";
        QTest::newRow("two apart, up") << Rows{1, 4} << std::size_t{0} << "140235";
        QTest::newRow("beyond the end") << Rows{2} << std::size_t{7} << "012345";
        QTest::newRow("not there") << Rows{8} << std::size_t{0} << "012345";
    }
    void movingPutsHitsTogether() {
        QFETCH(const Rows, rows);
        QFETCH(const std::size_t, to);
        QFETCH(const QString, order);
        HitHistory history = historyOf(6);
        const std::vector<Hit> before = hitsOf(history);
        const std::vector<HistoryEdit> edits = history.move(rows, to);
        QCOMPARE(orderOf(history), order);
        QCOMPARE(followed(before, edits), hitsOf(history));
        for (const HistoryEdit& edit : edits) {
            QVERIFY(edit.before.size() + edit.after.size() <= rows.size());
        }
    }

    void removingSeesRunsOfNeighbours() {
        HitHistory history = historyOf(8);
        const std::vector<Hit> before = hitsOf(history);
        const std::vector<HistoryEdit> edits = history.remove(Rows{6, 1, 2, 2});
        QCOMPARE(orderOf(history), QStringLiteral("03457"));
        QCOMPARE(edits.size(), std::size_t{2});
        QCOMPARE(followed(before, edits), hitsOf(history));
    }

    void replacingChangesOnlyWhatDiffers() {
        HitHistory history = historyOf(6);
        const std::vector<Hit> hits = {hitOn(1, 9.0f), hitOn(1, 2.0f), hitOn(1, 8.0f)};
        const std::vector<HistoryEdit> edits = history.replace(Rows{0, 2, 5}, hits);
        QCOMPARE(orderOf(history), QStringLiteral("912348"));
        QCOMPARE(edits.size(), std::size_t{2});
        QVERIFY(history.setEnabled(Rows{3, 1}, true).empty());
        QCOMPARE(history.setEnabled(Rows{3, 1}, false).size(), std::size_t{2});
        QVERIFY(!history.hits()[1].enabled && history.hits()[2].enabled && !history.hits()[3].enabled);
    }

    void manyRunsAreOneEdit() {
        const Rows rows = everyOther(400);
        const std::vector<Hit> before = hitsOf(historyOf(400));
        const auto check = [&before](const auto& change, const std::vector<Hit>& after) {
            HitHistory history = historyOf(before.size());
            const std::vector<HistoryEdit> edits = change(history);
            QCOMPARE(edits.size(), std::size_t{1});
            QCOMPARE(hitsOf(history), after);
            QCOMPARE(followed(before, edits), after);
        };
        std::vector<Hit> left = before;
        std::erase_if(left, [](const Hit& hit) { return static_cast<int>(hit.point.x) % 2 == 1; });
        check([&rows](HitHistory& history) { return history.remove(rows); }, left);
        std::vector<Hit> disabled = before;
        for (const std::size_t row : rows) {
            disabled[row].enabled = false;
        }
        check([&rows](HitHistory& history) { return history.setEnabled(rows, false); }, disabled);
        for (const std::size_t to : {std::size_t{0}, std::size_t{77}, std::size_t{200}, std::size_t{400}}) {
            check([&rows, to](HitHistory& history) { return history.move(rows, to); },
                  moved(before, rows, to));
        }
    }

    void movesAtRandomAreAsTheyShouldBe() {
        std::mt19937 random(11);
        for (int i = 0; i < 300; ++i) {
            const std::size_t size = 1 + random() % (i % 3 == 0 ? 300 : 12);
            HitHistory history = historyOf(size);
            const std::vector<Hit> before = hitsOf(history);
            Rows rows;
            for (std::size_t row = 0; row < size; ++row) {
                if (random() % 2 == 0) {
                    rows.push_back(row);
                }
            }
            const std::size_t to = random() % (size + 1);
            Rows shuffled = rows;
            std::shuffle(shuffled.begin(), shuffled.end(), random);
            const std::vector<HistoryEdit> edits = history.move(shuffled, to);
            QCOMPARE(hitsOf(history), moved(before, rows, to));
            QCOMPARE(followed(before, edits), hitsOf(history));
        }
    }
};

HITSCOPE_TEST(HitHistoryTest, QCoreApplication)

}  // namespace hitscope::hit_history_test

#include "hit_history_test.moc"
