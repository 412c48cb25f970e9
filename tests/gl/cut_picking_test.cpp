// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels of targets that a cutting plane opens, held against rays cast by the CPU.
#include <QTest>
#include <algorithm>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "analysis/comparison.h"
#include "analysis/scene_section.h"
#include "gl/picking_support.h"
#include "gl/pipeline_rows.h"
#include "gl/render_target.h"
#include "support/test_program.h"

namespace hitscope::cut_picking_test {

using Depth = ScenePicker::Depth;

class CutPickingTest : public QObject, private hitscope::test::PickedScene {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { start(); }
    void cleanup() { close(); }
    void cleanupTestCase() { m_context.reset(); }

    void nothingThatIsCutAwayIsPicked_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("wireframe");
        for (const PipelineTraits& traits : allPipelines()) {
            const auto kind = static_cast<int>(traits.kind);
            QTest::addRow("%s", std::string(traits.key).c_str()) << kind << 0;
            QTest::addRow("%s, wireframe", std::string(traits.key).c_str()) << kind << 2;
        }
    }
    void nothingThatIsCutAwayIsPicked() {
        QFETCH(int, kind);
        QFETCH(int, wireframe);
        HITSCOPE_NEEDS_PIPELINE(kind);
        open(static_cast<PipelineKind>(kind));
        SceneGpu::View view = viewOf(1.0f);
        view.options.wireframe = static_cast<WireframeMode>(wireframe);
        view.options.cut = cutOf();
        std::mt19937 random(static_cast<unsigned>(kind) + 3u);
        std::uniform_real_distribution<float> x(0.0f, static_cast<float>(view.width));
        std::uniform_real_distribution<float> y(0.0f, static_cast<float>(view.height));
        int onTargets = 0;
        for (int i = 0; i < 150; ++i) {
            const glm::vec2 at(x(random), y(random));
            const auto picked = m_picker->pick(view, at);
            QVERIFY(picked.ok());
            if (const auto& vertex = picked.value()) {
                ++onTargets;
                const Target& target = *m_session->targets().find(vertex->target);
                QVERIFY(!view.options.cut.hides(
                    target.transform.toWorld(target.deformed.positions()[vertex->vertex])));
            }
            QVERIFY2(wireframe != 0 || isSeenAt(view, at, picked.value()),
                     qPrintable(QStringLiteral("pixel %1, %2").arg(at.x).arg(at.y)));
        }
        QVERIFY2(onTargets > 20, qPrintable(QString::number(onTargets)));
    }

    void outlinesHoldNothingThatIsCutAway() {
        open(PipelineKind::TransformFeedback);
        SceneGpu::View view = viewOf(1.0f);
        view.camera.frame(m_session->targets().bounds(), 640.0f / 480.0f);
        view.options.cut = cutOf();
        const std::vector<glm::vec2> all{{0.0f, 0.0f}, {640.0f, 0.0f}, {640.0f, 480.0f}, {0.0f, 480.0f}};
        const auto through = m_picker->changedWithin(view, all, Depth::Through);
        const auto visible = m_picker->changedWithin(view, all, Depth::Visible);
        QVERIFY(through.ok() && visible.ok());
        std::size_t kept = 0;
        std::size_t found = 0;
        int seen = 0;
        int wrong = 0;
        for (const std::unique_ptr<Target>& target : m_session->targets()) {
            const auto here = through.value().find(target->id);
            found += here == through.value().end() ? 0 : here->second.size();
            const auto shown = visible.value().find(target->id);
            for (std::uint32_t vertex = 0; vertex < target->deformed.positions().size(); ++vertex) {
                const glm::vec3 world = target->transform.toWorld(target->deformed.positions()[vertex]);
                if (!target->deformed.isChanged(vertex) || view.options.cut.hides(world)) {
                    continue;
                }
                ++kept;
                const bool is = shown != visible.value().end() &&
                                std::binary_search(shown->second.begin(), shown->second.end(), vertex);
                seen += is ? 1 : 0;
                wrong += is != isInView(view, {target->id, vertex}) ? 1 : 0;
            }
        }
        QCOMPARE(found, kept);
        QVERIFY(seen > 30);
        QVERIFY2(wrong * 30 < seen, qPrintable(QStringLiteral("%1 of %2").arg(wrong).arg(seen)));
    }

    void bothOfTwoPicturesAreCut() {
        open(PipelineKind::UniformArrayCulled);
        Comparison comparison(*m_session);
        comparison.setOther(PipelineKind::Reference);
        SceneGpu::View view = viewOf(1.0f);
        view.comparison = &comparison;
        view.options.sideBySide = true;
        view.options.beforeAfter.wipe = true;
        view.options.beforeAfter.ghost = GhostMode::Wire;
        view.options.shadows = true;
        view.section = sectionLines(*m_session, cutOf(), 1.0f);
        view.showsCutPlane = true;
        const gl::RenderTarget target(view.width, view.height, 4);
        const auto drawn = [&] {
            for (int frames = 0; frames < 3; ++frames) {  // the second pipeline's come with the first
                if (!m_gpu->draw(view, target.framebuffer())) {
                    return Image();
                }
            }
            return target.read();
        };
        const Image whole = drawn();
        view.options.cut = cutOf();
        const Image opened = drawn();
        const int half = view.width / 2;
        int differ[2] = {};
        QCOMPARE(opened.pixels.size(), whole.pixels.size());
        for (std::size_t i = 0; i < whole.pixels.size(); i += 4) {
            const int column = static_cast<int>(i / 4) % view.width;
            differ[column / half] += whole.pixels[i] != opened.pixels[i] ? 1 : 0;
        }
        QVERIFY2(differ[0] > 2000 && differ[1] > 2000,
                 qPrintable(QStringLiteral("%1, %2").arg(differ[0]).arg(differ[1])));
        for (float x = 5.5f; x < 640.0f; x += 31.0f) {
            const auto picked = m_picker->pick(view, {x, 240.5f});
            QVERIFY(picked.ok());
            QVERIFY(isSeenAt(view, {x, 240.5f}, picked.value()));
        }
    }

private:
    /// Slantwise through all three targets, open towards the camera.
    [[nodiscard]] static CuttingPlane cutOf() {
        CuttingPlane cut;
        cut.on = true;
        cut.normal = glm::normalize(glm::vec3(0.3f, 0.2f, 1.0f));
        cut.offset = 0.2f;
        return cut;
    }
};

HITSCOPE_TEST(CutPickingTest, QCoreApplication)

}  // namespace hitscope::cut_picking_test

#include "cut_picking_test.moc"
