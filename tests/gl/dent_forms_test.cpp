// SPDX-License-Identifier: GPL-3.0-or-later
// Every form of a dent, in every pipeline, in every bit as the C++ reference has it.
#include <QTest>
#include <algorithm>
#include <map>
#include <random>

#include "deform/dent_form_text.h"
#include "gl/pipeline_rows.h"
#include "gl/pipeline_support.h"
#include "mesh/geodesic_sphere.h"
#include "pipeline/hit_arrays.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::dent_forms_test {

using namespace test;

namespace {

constexpr std::size_t kHits = 10'000;
constexpr std::size_t kArrayHits = 600;

bool isLimited(PipelineKind kind) {
    return !pipelineTraits(kind).keepsAll;
}

/// All profiles with either of two directions, the press, and all of them mixed.
struct Form {
    QByteArray name;
    std::optional<DentForm> form;  ///< nothing: mixed
};

std::vector<Form> allForms() {
    std::vector<Form> forms;
    for (std::size_t direction = 0; direction < 2; ++direction) {
        for (std::size_t profile = 0; profile < kDentProfileKeys.size(); ++profile) {
            DentForm form;
            form.profile = static_cast<DentProfile>(profile);
            form.direction = static_cast<DentDirection>(direction);
            const std::string name =
                std::string(keyOf(form.profile)) + ", " + std::string(keyOf(form.direction));
            forms.push_back({QByteArray::fromStdString(name), form});
        }
    }
    DentForm press;
    press.direction = DentDirection::Press;
    forms.push_back({"press", press});
    forms.push_back({"mixed", std::nullopt});
    return forms;
}

/// Small ones, so that 10,000 leave a surface: each has its own constants, normal, curve and radius.
std::vector<Hit> formedHits(const TestScene& scene, std::size_t count, const std::optional<DentForm>& form) {
    std::mt19937 random(23);
    std::uniform_real_distribution<float> share(0.0f, 1.0f);
    const std::vector<Form> all = allForms();
    std::vector<Hit> hits = randomHits(scene, 29, count);
    for (Hit& hit : hits) {
        hit.constants = {0.05f + 0.2f * share(random), 0.002f * share(random), 0.05f * share(random)};
        hit.form = form ? *form : *all[random() % (all.size() - 1)].form;
        if (hit.form.profile == DentProfile::Curve) {
            std::generate(hit.form.curve.begin(), hit.form.curve.end(),
                          [&] { return 2.0f * share(random) - 1.0f; });
        }
        hit.form.radius = 0.02f + 0.1f * share(random);
        if (random() % 8 != 0) {  // else: not known
            hit.normal = glm::vec3(share(random), share(random), share(random)) - 2.0f * hit.direction;
        }
        hit = checkedHit(hit).value();
    }
    return hits;
}

}  // namespace

class DentFormsTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open()) {
            HITSCOPE_NEEDS_EXACT_ARITHMETIC();
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void tenThousandHitsEqualReference_data() {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("form");
        const std::vector<Form> forms = allForms();
        for (const PipelineTraits& traits : allPipelines()) {
            for (std::size_t form = 0; form < forms.size(); ++form) {
                QTest::addRow("%s, %s", std::string(traits.key).c_str(), forms[form].name.constData())
                    << static_cast<int>(traits.kind) << static_cast<int>(form);
            }
        }
    }
    // All forms mixed on 100,000 vertices, and each alone on 25,000, since its function is the same anywhere.
    // Of uniform arrays, which keep no more, the last 600 count.
    void tenThousandHitsEqualReference() {
        QFETCH(const int, kind);
        QFETCH(const int, form);
        HITSCOPE_NEEDS_PIPELINE(kind);
        const bool isMixed = !allForms()[static_cast<std::size_t>(form)].form;
        TestScene scene;
        scene.emplace_back(1u, isMixed ? m_large : m_small);
        QVERIFY(scene[0].mesh.vertices.size() >= (isMixed ? 100'000u : 25'000u));
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        const std::vector<Hit> hits =
            formedHits(scene, kHits, allForms()[static_cast<std::size_t>(form)].form);
        Mirror mirror(scene);
        pipeline->reset(hits);
        mirror.readBack(*pipeline);
        const std::size_t kept = isLimited(static_cast<PipelineKind>(kind))
                                     ? pipeline->capacity().capacity.value_or(0)
                                     : hits.size();
        QCOMPARE(pipeline->capacity().dropped.size(), hits.size() - kept);
        const std::span<const Hit> applied = std::span(hits).last(kept);
        QCOMPARE(differenceFromReference(mirror, scene, applied), QString());
        QVERIFY(!difference(mirror.vertices(scene[0].id), scene[0].mesh.vertices).isEmpty());
    }

    void formsComeAndGo_data() { addPipelines(); }
    // One hit of another form among the paper's: programs are taken up and left again.
    void formsComeAndGo() {
        QFETCH(const int, kind);
        HITSCOPE_NEEDS_PIPELINE(kind);
        TestScene scene = makeScene({QStringLiteral("High-poly sphere"), QStringLiteral("Low-poly cube")});
        const auto pipeline = pipelineOn(static_cast<PipelineKind>(kind), scene);
        QVERIFY(pipeline);
        std::vector<Hit> hits = randomHits(scene, 31, 60, 4);
        Mirror mirror(scene);
        pipeline->reset(hits);
        const auto check = [&](const char* when) {
            mirror.readBack(*pipeline);
            const QString other = differenceFromReference(mirror, scene, hits);
            QVERIFY2(other.isEmpty(), qPrintable(QString::fromLatin1(when) + QStringLiteral(": ") + other));
        };
        check("paper");
        const auto change = [&](std::size_t index, const DentForm& form) {
            Hit hit = hits[index];
            hit.form = form;
            hit = checkedHit(hit).value();
            pipeline->edit({index, {hits[index]}, {hit}});
            hits[index] = hit;
        };
        change(20, {.profile = DentProfile::Crater});
        check("crater");
        change(40,
               {.curve = {0.5f, 1.0f, -0.5f, 0.2f, 0.2f, 0.3f, 0.1f, 0.1f}, .profile = DentProfile::Curve});
        check("curve");
        change(59, {.radius = 0.4f, .direction = DentDirection::Press});
        check("press");
        change(40, {});
        change(20, {});
        change(59, {});
        check("paper again");
    }

    void fewUniformsKeepFewerForms_data() {
        QTest::addColumn<int>("components");
        QTest::addColumn<int>("blockBytes");
        QTest::newRow("what OpenGL promises") << 1024 << 16384;
        QTest::newRow("a block of 64 KiB") << 1024 << 65536;
        QTest::newRow("no room in a block") << 4096 << 1024;
    }
    // The oldest are dropped when hits, or different curves, fill what there is.
    void fewUniformsKeepFewerForms() {
        QFETCH(const int, components);
        QFETCH(const int, blockBytes);
        const HitRoom block = formsInBlock(blockBytes);
        const HitRoom floats = formsInUniforms(HitStorage::Floats, components);
        const HitRoom room = block.hits + block.curves > floats.hits + floats.curves ? block : floats;
        PipelineOptions options = pipelineOptions();
        options.vertexUniformComponents = components;
        options.uniformBlockBytes = blockBytes;
        Result<std::unique_ptr<DeformationPipeline>> made = makePipeline(PipelineKind::UniformArray, options);
        QVERIFY(made.ok());
        TestScene scene = makeScene({QStringLiteral("Low-poly sphere")});
        DeformationPipeline& pipeline = *made.value();
        pipeline.addTarget(scene[0].id, *scene[0].buffers);
        for (const auto profile : {DentProfile::Crater, DentProfile::Curve}) {
            const std::vector<Hit> hits = formedHits(scene, 700, DentForm{.profile = profile});
            const std::size_t kept =
                profile == DentProfile::Curve ? std::min(room.curves, room.hits) : room.hits;
            Mirror mirror(scene);
            pipeline.reset(hits);
            mirror.readBack(pipeline);
            QCOMPARE(pipeline.capacity().dropped.size(), hits.size() - kept);
            QCOMPARE(differenceFromReference(mirror, scene, std::span(hits).last(kept)), QString());
        }
    }

    void sixHundredCurvesFit() {
        const HitRoom room = formsInBlock(65536);
        QCOMPARE(room.hits, kArrayHits);
        QCOMPARE(room.curves, kArrayHits);
    }

private:
    GlFixture m_gl;
    const RenderMesh m_large = buildRenderMesh(makeGeodesicSphere(100, 2.5f));
    const RenderMesh m_small = buildRenderMesh(makeGeodesicSphere(50, 2.5f));
};

HITSCOPE_TEST(DentFormsTest, QCoreApplication)

}  // namespace hitscope::dent_forms_test

#include "dent_forms_test.moc"
