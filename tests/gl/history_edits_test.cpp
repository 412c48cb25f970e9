// SPDX-License-Identifier: GPL-3.0-or-later
// A history that is changed in every way: after each change every pipeline has what applying the hits from
// the start gives, in every bit, whether it is read back at once or as it arrives.
#include <QTest>
#include <random>

#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::history_edits_test {

using namespace test;

namespace {

/// Makes random edits of a history: hits added, taken out, moved, disabled, given other constants, undone.
class Editor {
public:
    Editor(const TestScene& scene, std::uint32_t seed)
        : m_random(seed), m_hits(randomHits(scene, seed, 4000, 3)) {}

    std::vector<HistoryEdit> next(HitHistory& history) {
        const std::size_t size = history.size();
        const auto what = m_random() % 10;
        if (size < 30 || what < 4) {
            const std::size_t count = 1 + m_random() % 8;
            return {record(history.append(take(count)))};
        }
        const std::size_t index = m_random() % size;
        switch (what) {
            case 4:
                return {record(history.splice(index, 1, {}))};
            case 5:
                return history.move(std::vector{index}, m_random() % (size + 1));
            case 6:
                return toggle(history, index);
            case 7:
                return {record(history.splice(index, 0, take(2)))};
            case 8:
                return history.remove(std::vector{size - 1});
            default:
                return undoLast(history);
        }
    }

private:
    std::span<const Hit> take(std::size_t count) {
        m_next = (m_next + count) % (m_hits.size() - 10);
        return std::span<const Hit>(m_hits).subspan(m_next, count);
    }
    HistoryEdit record(HistoryEdit edit) {
        m_last = edit;
        m_canUndo = true;
        m_sizeAfter = edit.after.size();
        return edit;
    }
    std::vector<HistoryEdit> toggle(HitHistory& history, std::size_t index) {
        std::vector<HistoryEdit> edits =
            history.setEnabled(std::vector{index}, !history.hits()[index].enabled);
        record(edits.front());
        return edits;
    }
    std::vector<HistoryEdit> undoLast(HitHistory& history) {
        if (!m_canUndo || history.size() < m_last.first + m_sizeAfter ||
            !std::equal(m_last.after.begin(), m_last.after.end(),
                        history.hits().begin() + static_cast<std::ptrdiff_t>(m_last.first))) {
            return {};
        }
        m_canUndo = false;
        return {history.splice(m_last.first, m_last.after.size(), m_last.before)};
    }

    std::mt19937 m_random;
    std::vector<Hit> m_hits;
    std::size_t m_next = 0;
    HistoryEdit m_last;
    std::size_t m_sizeAfter = 0;
    bool m_canUndo = false;
};

}  // namespace

class HistoryEditsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void everyEditEqualsAFreshStart_data() { addPipelines(); }
    void everyEditEqualsAFreshStart() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere"), QStringLiteral("High-poly cube")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        HitHistory history;
        Editor editor(scene, 71);
        Mirror mirror(scene);
        for (int i = 0; i < 250; ++i) {
            for (const HistoryEdit& edit : editor.next(history)) {
                pipeline->edit(edit);
            }
            if (i % 3 == 0) {
                mirror.readBack(*pipeline);
                QCOMPARE(differenceFromReference(mirror, scene, enabled(history)), QString());
            }
        }
        QVERIFY(history.size() > 100);
        QCOMPARE(pipeline->capacity().dropped.size(), std::size_t{0});
    }

    // As the window reads: never waiting, and what comes is some frames old while more is changed.
    void whatArrivesLateIsRightInTheEnd_data() { addPipelines(); }
    void whatArrivesLateIsRightInTheEnd() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere"), QStringLiteral("Low-poly cube")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        HitHistory history;
        Editor editor(scene, 73);
        Mirror mirror(scene);
        for (int round = 0; round < 20; ++round) {
            for (int frame = 0; frame < 8; ++frame) {
                for (const HistoryEdit& edit : editor.next(history)) {
                    pipeline->edit(edit);
                }
                mirror.poll(*pipeline);
            }
            QTRY_VERIFY_WITH_TIMEOUT((mirror.poll(*pipeline), !pipeline->isReadBackPending()), kPatience);
            QCOMPARE(differenceFromReference(mirror, scene, enabled(history)), QString());
        }
    }

    // Undone one after the other, and made again, with far more hits than are kept for undoing.
    void undoAllTheWayAndBack_data() { addPipelines(); }
    void undoAllTheWayAndBack() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        const std::vector<Hit> hits = randomHits(scene, 79, 500);
        HitHistory history;
        Mirror mirror(scene);
        for (std::size_t i = 0; i < hits.size(); i += 5) {
            pipeline->edit(history.append(std::span(hits).subspan(i, 5)));
        }
        for (std::size_t left = hits.size(); left > 0; left -= 5) {
            pipeline->edit(history.splice(left - 5, 5, {}));
            if (left % 100 == 5 || left == hits.size()) {
                mirror.readBack(*pipeline);
                QCOMPARE(differenceFromReference(mirror, scene, history.hits()), QString());
            }
        }
        mirror.readBack(*pipeline);
        QCOMPARE(difference(mirror.vertices(scene[0].id), scene[0].mesh.vertices), QString());
        pipeline->edit(history.append(hits));
        mirror.readBack(*pipeline);
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());
    }

    // Of 5,000 hits one is taken out: only what it can have reached is delivered.
    void removingOneOfManyIsLocal_data() {
        QTest::addColumn<int>("kind");
        for (const PipelineTraits& traits : allPipelines()) {
            if (traits.keepsAll) {
                QTest::newRow(traits.key.data()) << static_cast<int>(traits.kind);
            }
        }
    }
    void removingOneOfManyIsLocal() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        HitHistory history;
        std::vector<Hit> hits = randomHits(scene, 83, 5000);
        for (Hit& hit : hits) {
            hit.constants = {0.3f, 0.001f, 0.01f};
        }
        pipeline->edit(history.append(hits));
        Mirror mirror(scene);
        mirror.readBack(*pipeline);
        for (const std::size_t index : {std::size_t{2500}, std::size_t{0}, std::size_t{4900}}) {
            pipeline->edit(history.splice(index, 1, {}));
            const std::size_t delivered = mirror.readBack(*pipeline);
            QVERIFY(delivered > 0 && delivered < scene[0].mesh.vertices.size() / 5);
            QCOMPARE(differenceFromReference(mirror, scene, history.hits()), QString());
        }
    }

    void targetsThatComeLateGetTheirHits_data() { addPipelines(); }
    void targetsThatComeLateGetTheirHits() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("Low-poly cube"), QStringLiteral("Low-poly sphere")});
        Result<std::unique_ptr<DeformationPipeline>> pipeline =
            makePipeline(static_cast<PipelineKind>(kind), pipelineOptions());
        QVERIFY(pipeline.ok());
        const std::vector<Hit> hits = randomHits(scene, 89, 60);
        pipeline.value()->append(hits);
        for (TestTarget& target : scene) {
            pipeline.value()->addTarget(target.id, *target.buffers);
        }
        Mirror mirror(scene);
        mirror.readBack(*pipeline.value());
        QCOMPARE(differenceFromReference(mirror, scene, hits), QString());
    }

private:
    static std::vector<Hit> enabled(const HitHistory& history) {
        std::vector<Hit> hits(history.hits().begin(), history.hits().end());
        std::erase_if(hits, [](const Hit& hit) { return !hit.enabled; });
        return hits;
    }

    GlFixture m_gl;
};

HITSCOPE_TEST(HistoryEditsTest, QCoreApplication)

}  // namespace hitscope::history_edits_test

#include "history_edits_test.moc"
