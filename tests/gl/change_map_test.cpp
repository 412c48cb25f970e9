// SPDX-License-Identifier: GPL-3.0-or-later
// Colour maps of change: pixels at known vertices against values worked out here, and the range that follows
// them.
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "analysis/change_values.h"
#include "analysis/hit_effects.h"
#include "deform/deform.h"
#include "gl/render_target.h"
#include "mesh/primitives.h"
#include "scene/scene_gpu.h"
#include "session/shots/demo_shots.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"
#include "view/theme.h"

namespace hitscope::change_map_test {

namespace {

constexpr int kSize = 65;  // pixels; odd, so that a pixel's centre is the picture's

/// The vertex in the middle of the picture, seen along its normal.
SceneGpu::View viewOf(const Target& target, std::uint32_t vertex, float distance) {
    const DynamicVertex& at = target.deformed.vertices()[vertex];
    const glm::vec3 n = target.trueNormals.normals()[vertex];
    SceneGpu::View view;
    view.width = kSize;
    view.height = kSize;
    view.camera.setSceneRadius(3.0f);
    view.camera.setPivot(target.transform.toWorld(at.position), std::atan2(n.x, n.z), std::asin(n.y),
                         distance);
    view.options.floor = false;
    return view;
}

double encoded(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

/// The colour that a value has where the surface makes this cosine with the view.
std::array<int, 3> colourOf(const ShownChange& change, double value, double facing) {
    const double low = static_cast<double>(change.range.low);
    const double high = static_cast<double>(change.range.high);
    const double at = std::clamp((value - low) / (high - low), 0.0, 1.0) * 255.0;
    const auto first = static_cast<std::size_t>(std::min(at, 254.0));
    const ColourTable& table = colourTable(change.map);
    std::array<int, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto linear = [&](std::size_t entry) {
            return static_cast<double>(toLinear(glm::vec3(static_cast<float>(table[entry][c]) / 255.0f)).x);
        };
        const double mixed = std::lerp(linear(first), linear(first + 1), at - static_cast<double>(first));
        colour[c] = static_cast<int>(std::lround(255.0 * encoded(mixed * std::lerp(0.35, 1.0, facing))));
    }
    return colour;
}

}  // namespace

class ChangeMapTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { m_gl.open(); }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void pixelsShowTheValues_data() {
        QTest::addColumn<int>("quantity");
        QTest::addColumn<int>("kind");
        for (const ChangeTraits& traits : allChangeQuantities()) {
            for (const PipelineKind kind : {PipelineKind::TransformFeedback, PipelineKind::UniformArray}) {
                QTest::addRow("%s, %s", std::string(traits.key).c_str(),
                              std::string(pipelineTraits(kind).key).c_str())
                    << static_cast<int>(traits.quantity) << static_cast<int>(kind);
            }
        }
    }
    void pixelsShowTheValues() {
        QFETCH(int, quantity);
        QFETCH(int, kind);
        open(static_cast<PipelineKind>(kind));
        shootAll(*m_session, demoShots(*m_session, 20, 3));
        HitEffects effects(*m_session);
        effects.finish();
        m_values->setHitCounts([&effects](TargetId id) { return effects.counts(id); });
        QVERIFY(m_gpu->sync());
        const Target& target = *m_session->targets().front();
        std::vector<DynamicVertex> others(target.deformed.vertices().begin(),
                                          target.deformed.vertices().end());
        for (DynamicVertex& other : others) {
            other.position.x += 0.02f * std::sin(40.0f * other.position.y);
        }
        m_values->setOtherVertices([&others](TargetId) { return std::span<const DynamicVertex>(others); });
        m_values->setQuantity(static_cast<ChangeQuantity>(quantity));
        m_values->finish();

        int looked = 0;
        const auto vertices = target.deformed.vertices();
        for (std::uint32_t v = 0; v < vertices.size() && looked < 12; v += 5) {
            if (!target.deformed.isChanged(target.deformed.render().fileVertices[v])) {
                continue;
            }
            ++looked;
            checkVertex(target, v, static_cast<ChangeQuantity>(quantity), others[v]);
        }
        QCOMPARE(looked, 12);
    }

    void nothingMovedIsTheMiddleOfADivergingMap() {
        open(PipelineKind::TransformFeedback);
        QVERIFY(m_gpu->sync());
        const QColor colour = middle(ChangeQuantity::AlongNormal, 100);
        // Neutral: red, green and blue alike.
        QVERIFY2(std::abs(colour.red() - colour.green()) < 3 && std::abs(colour.red() - colour.blue()) < 3 &&
                     colour.red() > 200,
                 qPrintable(colour.name()));
    }

    void rangeFollowsTheHitsAndTheirUndoing() {
        open(PipelineKind::TransformFeedback);
        m_values->setQuantity(ChangeQuantity::Displacement);
        QCOMPARE(m_values->summary().count, std::size_t{0});
        shootAll(*m_session, demoShots(*m_session, 3, 3));
        QVERIFY(m_gpu->sync());
        m_values->finish();
        const auto isRight = [this] {
            const DisplacementStatistics statistics = m_session->targets().front()->deformed.statistics();
            const Summary summary = m_values->summary();
            return summary.count == statistics.changedVertices &&
                   (summary.count == 0 || (std::abs(summary.high - statistics.maximum) < 1e-9 &&
                                           std::abs(summary.rootMeanSquare() - statistics.rms) < 1e-9));
        };
        QVERIFY(isRight());
        const double three = m_values->summary().high;
        shootAll(*m_session, demoShots(*m_session, 30, 4));
        QVERIFY(m_gpu->sync());
        m_values->finish();
        QVERIFY(isRight());
        QVERIFY(m_values->summary().high > three);
        while (m_session->hits().history().size() > 3) {
            m_session->undo();
        }
        QVERIFY(m_gpu->sync());
        m_values->finish();
        QVERIFY(isRight());
        QCOMPARE(m_values->summary().high, three);
        m_session->hits().clear();
        QVERIFY(m_gpu->sync());
        m_values->finish();
        QVERIFY(isRight());
        QCOMPARE(m_values->summary().count, std::size_t{0});
        QCOMPARE(shownRange({}, m_values->summary()),
                 defaultQuantityStyles()[static_cast<std::size_t>(ChangeQuantity::Displacement)].fixed);
    }

    void histogramHasEveryChangedVertex() {
        open(PipelineKind::TransformFeedback);
        shootAll(*m_session, demoShots(*m_session, 20, 3));
        QVERIFY(m_gpu->sync());
        m_values->setHistogramWanted(true);
        for (const ChangeTraits& traits : allChangeQuantities()) {
            if (!traits.inShader || traits.quantity == ChangeQuantity::TrueNormalError) {
                continue;
            }
            m_values->setQuantity(traits.quantity);
            m_values->finish();
            std::size_t sum = 0;
            for (const std::uint32_t count : m_values->histogram().counts) {
                sum += count;
            }
            QCOMPARE(sum, m_session->targets().front()->deformed.statistics().changedVertices);
        }
    }

private:
    void open(PipelineKind kind) {
        m_gpu.reset();
        m_values.reset();
        m_session = std::make_unique<Session>();
        loadMesh(*m_session, makeHighPolySphere());
        m_session->settings().setPipeline(kind);
        auto made = SceneGpu::create(*m_session);
        QVERIFY2(made.ok(), made.ok() ? "" : made.error().message().c_str());
        m_gpu = std::move(made).value();
        m_values = std::make_unique<ChangeValues>(*m_session);
    }

    QColor pixel(const SceneGpu::View& view) {
        const gl::RenderTarget picture(kSize, kSize);
        if (!m_gpu->draw(view, picture.framebuffer())) {
            QTest::qFail("nothing is drawn", __FILE__, __LINE__);
            return {};
        }
        const Image image = picture.read();
        const std::size_t at = 4 * (static_cast<std::size_t>(kSize / 2) * kSize + kSize / 2);
        return {image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]};
    }

    QColor middle(ChangeQuantity quantity, std::uint32_t vertex) {
        SceneGpu::View view = viewOf(*m_session->targets().front(), vertex, 0.5f);
        view.options.change.on = true;
        view.options.change.quantity = quantity;
        view.changeValues = m_values.get();
        return pixel(view);
    }

    void checkVertex(const Target& target, std::uint32_t v, ChangeQuantity quantity,
                     const DynamicVertex& other) {
        const DeformedMesh& mesh = target.deformed;
        const DynamicVertex& now = mesh.vertices()[v];
        const glm::vec3 normal = target.trueNormals.normals()[v];
        double value = changeOf(quantity, mesh.render().vertices[v], now, normal);
        if (quantity == ChangeQuantity::HitCount) {
            int count = 0;
            DynamicVertex walking = mesh.render().vertices[v];
            for (const Hit& hit : m_session->hits().history().hits()) {
                count += deform(walking.position, walking.normal, hit) ? 1 : 0;
            }
            value = count;
        } else if (quantity == ChangeQuantity::EdgeStretch) {
            value = edgeStretch(EdgeNeighbours(mesh.render()), mesh.render().fileVertices[v],
                                mesh.original().positions, mesh.positions());
        } else if (quantity == ChangeQuantity::Difference) {
            value = static_cast<double>(glm::distance(now.position, other.position));
        }
        SceneGpu::View view = viewOf(target, v, 0.06f);
        view.options.change.on = true;
        view.options.change.quantity = quantity;
        view.changeValues = m_values.get();
        const QColor seen = pixel(view);
        const double facing = static_cast<double>(std::abs(
            glm::dot(normal, glm::normalize(view.camera.eye() - target.transform.toWorld(now.position)))));
        const ShownChange change = shownChange(view.options.change, m_values->summary());
        const std::array<int, 3> expected = colourOf(change, value, facing);
        const QString what = QStringLiteral("vertex %1: %2, seen %3, expected %4 %5 %6")
                                 .arg(v)
                                 .arg(value)
                                 .arg(seen.name())
                                 .arg(expected[0], 0, 16)
                                 .arg(expected[1], 0, 16)
                                 .arg(expected[2], 0, 16);
        QVERIFY2(std::abs(seen.red() - expected[0]) <= 3 && std::abs(seen.green() - expected[1]) <= 3 &&
                     std::abs(seen.blue() - expected[2]) <= 3,
                 qPrintable(what));
    }

    test::GlFixture m_gl;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<ChangeValues> m_values;
    std::unique_ptr<SceneGpu> m_gpu;
};

HITSCOPE_TEST(ChangeMapTest, QCoreApplication)

}  // namespace hitscope::change_map_test

#include "change_map_test.moc"
