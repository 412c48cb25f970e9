// SPDX-License-Identifier: GPL-3.0-or-later
// What pixels are said to show, held against rays cast by the CPU.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <random>
#include <set>

#include "analysis/comparison.h"
#include "gl/context.h"
#include "gl/picking_support.h"
#include "gl/pipeline_rows.h"
#include "mesh/primitives.h"
#include "scene/scene_picker.h"
#include "scene/screen_space.h"
#include "session/primitive_target.h"
#include "session/shots/demo_shots.h"
#include "support/test_program.h"

namespace hitscope::picking_test {

using test::PickedScene;
using test::Shown;
using Depth = ScenePicker::Depth;

class PickingTest : public QObject, private PickedScene {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { start(); }
    void cleanup() { close(); }
    void cleanupTestCase() { m_context.reset(); }

    void pixelsShowWhatRaysMeet_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<float>("ratio");
        const float ratios[] = {1.0f, 1.5f, 2.0f};
        int i = 0;
        for (const PipelineTraits& traits : allPipelines()) {
            const float ratio = ratios[i++ % 3];
            QTest::addRow("%s at %g", std::string(traits.key).c_str(), static_cast<double>(ratio))
                << static_cast<int>(traits.kind) << ratio;
        }
    }
    void pixelsShowWhatRaysMeet() {
        QFETCH(int, kind);
        QFETCH(float, ratio);
        HITSCOPE_NEEDS_PIPELINE(kind);
        open(static_cast<PipelineKind>(kind));
        const SceneGpu::View view = viewOf(ratio);
        std::mt19937 random(static_cast<unsigned>(kind) + 7u);
        std::uniform_real_distribution<float> x(0.0f, static_cast<float>(view.width));
        std::uniform_real_distribution<float> y(0.0f, static_cast<float>(view.height));
        int onTargets = 0;
        for (int i = 0; i < 1000 / static_cast<int>(allPipelines().size()) + 1; ++i) {
            const glm::vec2 at(x(random), y(random));
            const auto picked = m_picker->pick(view, at);
            QVERIFY(picked.ok());
            onTargets += picked.value().has_value() ? 1 : 0;
            QVERIFY2(isSeenAt(view, at, picked.value()),
                     qPrintable(QStringLiteral("pixel %1, %2: vertex %3 of target %4")
                                    .arg(at.x)
                                    .arg(at.y)
                                    .arg(picked.value() ? picked.value()->vertex : 0u)
                                    .arg(picked.value() ? picked.value()->target.value : 0u)));
        }
        QVERIFY2(onTargets > 80, qPrintable(QString::number(onTargets)));
    }

    void pixelsShowVerticesAsTheyAreDrawn_data() {
        QTest::addColumn<float>("factor");
        QTest::addColumn<bool>("wipe");
        QTest::addColumn<bool>("sideBySide");
        QTest::addRow("exaggerated") << 3.0f << false << false;
        QTest::addRow("wiped") << 1.0f << true << false;
        QTest::addRow("side by side") << 1.0f << false << true;
        QTest::addRow("all at once") << 3.0f << true << true;
    }
    void pixelsShowVerticesAsTheyAreDrawn() {
        open(PipelineKind::TransformFeedback);
        Comparison comparison(*m_session);
        comparison.setOther(PipelineKind::Reference);
        const SceneGpu::View view = changedView(comparison);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> x(0.0f, static_cast<float>(view.width));
        std::uniform_real_distribution<float> y(0.0f, static_cast<float>(view.height));
        int onTargets = 0;
        for (int i = 0; i < 250; ++i) {
            const glm::vec2 at(x(random), y(random));
            const auto picked = m_picker->pick(view, at);
            QVERIFY(picked.ok());
            onTargets += picked.value().has_value() ? 1 : 0;
            QVERIFY2(isSeenAt(view, at, picked.value()),
                     qPrintable(QStringLiteral("pixel %1, %2").arg(at.x).arg(at.y)));
        }
        QVERIFY2(onTargets > 40, qPrintable(QString::number(onTargets)));
    }

    /// Half of the picture after the other, and all of it at once.
    void outlinesHoldVerticesAsTheyAreDrawn_data() { pixelsShowVerticesAsTheyAreDrawn_data(); }
    void outlinesHoldVerticesAsTheyAreDrawn() {
        open(PipelineKind::TransformFeedback);
        Comparison comparison(*m_session);
        comparison.setOther(PipelineKind::Reference);
        const SceneGpu::View view = changedView(comparison);
        const float width = static_cast<float>(view.width) / (view.options.sideBySide ? 2.0f : 1.0f);
        const float left = view.options.sideBySide ? width : 0.0f;
        const glm::vec2 low(left + 0.3f * width, 0.3f * static_cast<float>(view.height));
        const glm::vec2 high(left + 0.7f * width, 0.6f * static_cast<float>(view.height));
        const std::vector<glm::vec2> box{low, {high.x, low.y}, high, {low.x, high.y}};
        const auto found = m_picker->changedWithin(view, box, Depth::Through);
        QVERIFY(found.ok());
        SceneGpu::View one = view;
        one.width = static_cast<int>(width);
        const BeforeAfterOptions& options = view.options.beforeAfter;
        std::size_t count = 0;
        for (const std::unique_ptr<Target>& target : m_session->targets()) {
            const ScreenSpace screen(one, target->transform);
            std::set<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < target->deformed.render().fileVertices.size(); ++i) {
                const std::uint32_t vertex = target->deformed.render().fileVertices[i];
                for (const bool original : {true, false}) {
                    const auto point =
                        screen.project(Shown{original, options.exaggeration}.placeOf(*target, i));
                    const bool isLeft = point && options.wipe && point->at.x < options.wipeAt * width;
                    if (point && isLeft == original && isWithin(box, point->at + glm::vec2(left, 0.0f)) &&
                        target->deformed.isChanged(vertex)) {
                        expected.insert(vertex);
                    }
                }
            }
            const auto here = found.value().find(target->id);
            const std::vector<std::uint32_t> got =
                here == found.value().end() ? std::vector<std::uint32_t>() : here->second;
            QCOMPARE(got, std::vector<std::uint32_t>(expected.begin(), expected.end()));
            count += got.size();
        }
        QVERIFY(count > 20);
    }

    void laterAnswersAreTheSame() {
        open(PipelineKind::TransformFeedback);
        const SceneGpu::View view = viewOf(1.0f);
        for (int i = 0; i < 20; ++i) {
            const glm::vec2 at(200.5f + 10.0f * static_cast<float>(i), 240.5f);
            const auto now = m_picker->pick(view, at);
            QVERIFY(m_picker->request(view, at).ok());
            QVERIFY(m_picker->isPending());
            std::optional<std::optional<VertexRef>> later;
            QTRY_VERIFY_WITH_TIMEOUT(later || (later = m_picker->arrived()).has_value(), kPatience);
            QVERIFY(!m_picker->isPending());
            QCOMPARE(*later, now.value());
            QVERIFY(!m_picker->arrived().has_value());
        }
    }

    void wireframesGiveHiddenVerticesToo() {
        open(PipelineKind::UniformArrayCulled);
        SceneGpu::View view = viewOf(1.5f);
        view.options.wireframe = WireframeMode::Only;
        const Target& target = *m_session->targets().front();
        const ScreenSpace screen(view, target.transform);
        const std::span<const glm::vec3> positions = target.deformed.positions();
        const glm::vec2 size(static_cast<float>(view.width), static_cast<float>(view.height));
        int checked = 0;
        for (std::uint32_t vertex = 0; vertex < positions.size(); vertex += 29) {
            const auto point = screen.project(positions[vertex]);
            QVERIFY(point.has_value());
            if (!glm::all(glm::lessThan(glm::abs(point->at / size - 0.5f), glm::vec2(0.49f)))) {
                continue;  // not in the picture
            }
            const auto picked = m_picker->pick(view, point->at);
            QVERIFY(picked.ok());
            QVERIFY(picked.value().has_value());
            // Others may fall nearer to it than a pixel, those of other targets too.
            const Target& found = *m_session->targets().find(picked.value()->target);
            const auto at = ScreenSpace(view, found.transform)
                                .project(found.deformed.positions()[picked.value()->vertex]);
            QVERIFY(at && glm::distance(at->at, point->at) < 1.5f);
            ++checked;
        }
        QVERIFY(checked > 50);
        QVERIFY(!m_picker->pick(view, {2.5f, 2.5f}).value().has_value());
    }

    void outlinesGiveWhatTheyHold() {
        open(whyUnavailable(PipelineKind::Compute) ? PipelineKind::TransformFeedback : PipelineKind::Compute);
        SceneGpu::View view = viewOf(1.0f);
        view.camera.frame(m_session->targets().bounds(), 640.0f / 480.0f);
        const auto w = static_cast<float>(view.width);
        const auto h = static_cast<float>(view.height);
        const std::vector<glm::vec2> all{{0.0f, 0.0f}, {w, 0.0f}, {w, h}, {0.0f, h}};
        const auto through = m_picker->changedWithin(view, all, Depth::Through);
        QVERIFY(through.ok());
        std::size_t changed = 0;
        std::size_t found = 0;
        for (const std::unique_ptr<Target>& target : m_session->targets()) {
            changed += target->deformed.statistics().changedVertices;
            const auto here = through.value().find(target->id);
            found += here == through.value().end() ? 0 : here->second.size();
        }
        QVERIFY(changed > 200);
        QCOMPARE(found, changed);

        const auto visible = m_picker->changedWithin(view, all, Depth::Visible);
        QVERIFY(visible.ok());
        int seen = 0;
        int wrong = 0;
        int extra = 0;
        for (const auto& [id, vertices] : through.value()) {
            const auto here = visible.value().find(id);
            const std::vector<std::uint32_t> shown =
                here == visible.value().end() ? std::vector<std::uint32_t>() : here->second;
            QVERIFY(std::includes(vertices.begin(), vertices.end(), shown.begin(), shown.end()));
            for (const std::uint32_t vertex : vertices) {
                const bool is = std::binary_search(shown.begin(), shown.end(), vertex);
                seen += is ? 1 : 0;
                const bool should = isInView(view, {id, vertex});
                wrong += is != should ? 1 : 0;
                extra += is && !should ? 1 : 0;
            }
        }
        QVERIFY(seen > 50);
        QVERIFY(static_cast<std::size_t>(seen) < changed);
        // At a silhouette a pixel cannot tell what its neighbour hides.
        QVERIFY2(wrong * 30 < seen,
                 qPrintable(QStringLiteral("%1 of %2, %3 hidden").arg(wrong).arg(seen).arg(extra)));
    }

    void lassosHaveAnInside() {
        const std::vector<glm::vec2> bow{{0, 0}, {10, 0}, {0, 10}, {10, 10}};
        QVERIFY(isWithin(bow, {5, 2}));
        QVERIFY(isWithin(bow, {5, 8}));
        QVERIFY(!isWithin(bow, {1, 5}));
        QVERIFY(!isWithin(bow, {9, 5}));
        QVERIFY(!isWithin(bow, {5, -1}));
        QVERIFY(!isWithin({}, {5, 5}));
    }

private:
    /// With the row's way to show changes.
    [[nodiscard]] SceneGpu::View changedView(Comparison& comparison) const {
        QFETCH(float, factor);
        QFETCH(bool, wipe);
        QFETCH(bool, sideBySide);
        SceneGpu::View view = viewOf(1.0f);
        view.comparison = &comparison;
        view.options.sideBySide = sideBySide;
        view.options.beforeAfter.exaggeration = factor;
        view.options.beforeAfter.wipe = wipe;
        return view;
    }
};

HITSCOPE_TEST(PickingTest, QCoreApplication)

}  // namespace hitscope::picking_test

#include "picking_test.moc"
