// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <limits>
#include <random>

#include "deform/fingerprint.h"
#include "document/document_json.h"
#include "document_support.h"
#include "io_support.h"
#include "support/test_program.h"

namespace hitscope::document_json_test {

using namespace test;

/// Written and read; fails the test where that is refused.
SessionDocument again(const SessionDocument& document) {
    const Result<SessionDocument> read = readDocument(writeDocument(document));
    if (!read) {
        qWarning("%s", read.error().message().c_str());
        return {};
    }
    return read.value();
}

/// One member changed alone is in the file, comes back, and changes nothing else.
template <class Get, class Value>
void tryChange(const char* name, const Get& get, const Value& value) {
    const SessionDocument original = exampleDocument();
    SessionDocument changed = original;
    QVERIFY2(!isSame(get(changed), static_cast<std::decay_t<decltype(get(changed))>>(value)), name);
    get(changed) = value;
    const QByteArray bytes = writeDocument(changed);
    QVERIFY2(bytes != writeDocument(original), name);
    const Result<SessionDocument> result = readDocument(bytes);
    QVERIFY2(result.ok(), qPrintable(QLatin1String(name) + ": " + messageOf(result)));
    SessionDocument read = result.value();
    QVERIFY2(isSame(get(read), get(changed)), name);
    QVERIFY2(writeDocument(read) == bytes, name);
    get(read) = get(original);
    QVERIFY2(writeDocument(read) == writeDocument(original), name);
}

#define TRY_CHANGE(member, ...) \
    tryChange(                  \
        #member, [](auto& d) -> auto& { return d.member; }, __VA_ARGS__)

template <class Light>
void tryTerms(const char* name, const Light& light) {
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).terms.colour; }, glm::vec3(0.1f, 0.2f, 0.3f));
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).terms.ambient; }, 0.31f);
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).terms.diffuse; }, 0.32f);
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).terms.specular; }, 0.33f);
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).on; }, false);
}
template <class Light>
void tryPlaced(const char* name, const Light& light) {
    tryTerms(name, light);
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).position; }, glm::vec3(-9.0f, 1e20f, 0.3f));
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).attenuation.constant; }, 1.5f);
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).attenuation.linear; }, 1e-9f);
    tryChange(
        name, [&](auto& d) -> auto& { return light(d).attenuation.quadratic; }, 1e9f);
}

class DocumentJsonTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void comesBackWhole();
    void emptyComesBack();
    void bitsComeBack();
    void sceneAndTargets();
    void sources();
    void hits();
    void settings();
    void lights();
    void display();
    void selection();
    void eachHitHasALine();
    void olderFilesOpen();
    void membersAreKnown();
};

void DocumentJsonTest::comesBackWhole() {
    const SessionDocument original = exampleDocument();
    const QByteArray bytes = writeDocument(original);
    const Result<SessionDocument> read = readDocument(bytes);
    QVERIFY2(read.ok(), qPrintable(messageOf(read)));
    const SessionDocument& document = read.value();
    QCOMPARE(writeDocument(document), bytes);
    QCOMPARE(document.scene.name, original.scene.name);
    QCOMPARE(document.targets.size(), std::size_t(3));
    QVERIFY(document.targets[0].source == original.targets[0].source);
    QVERIFY(document.targets[0].textures == original.targets[0].textures);
    QVERIFY(document.cameras == original.cameras);
    QVERIFY(document.selection == original.selection);
    QVERIFY(document.positions == original.positions);
    QCOMPARE(document.hits.size(), original.hits.size());
    for (std::size_t i = 0; i < original.hits.size(); ++i) {
        QVERIFY(isSame(document.hits[i], original.hits[i]));
    }
}

void DocumentJsonTest::emptyComesBack() {
    const QByteArray bytes = writeDocument(SessionDocument());
    QVERIFY(again(SessionDocument()).hits.empty());
    QCOMPARE(writeDocument(again(SessionDocument())), bytes);
}

/// Any float there is, where the session may have any.
void DocumentJsonTest::bitsComeBack() {
    std::mt19937 random(1);
    SessionDocument document = exampleDocument();
    document.hits.clear();
    const auto any = [&random] {
        float value = 0.0f;
        do {
            value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        } while (!std::isfinite(value));
        return value;
    };
    for (int i = 0; i < 20'000; ++i) {
        Hit hit = exampleHit(1, 0.0f);
        hit.point = {any(), any(), any()};
        hit.normal = {any(), any(), any()};
        hit.flight = {any(), any(), any()};
        hit.speed = any();
        hit.time = static_cast<double>(any()) / 3.0;
        document.hits.push_back(hit);
    }
    constexpr float kTiny = std::numeric_limits<float>::denorm_min();
    constexpr float kLargest = std::numeric_limits<float>::max();
    Hit special = exampleHit(7, -0.0f);
    special.point = {-0.0f, kTiny, -kTiny};
    special.normal = {-0.0f, -0.0f, -0.0f};
    special.flight = {0.0f, -0.0f, 0.0f};
    special.speed = kLargest;
    special.impulse = -0.0f;
    special.time = -0.0;
    document.hits.push_back(special);
    special.time = std::numeric_limits<double>::denorm_min();
    document.hits.push_back(special);
    const SessionDocument read = again(document);
    QCOMPARE(read.hits.size(), document.hits.size());
    for (std::size_t i = 0; i < document.hits.size(); ++i) {
        QVERIFY2(isSame(read.hits[i], document.hits[i]), qPrintable(QString::number(i)));
    }
}

void DocumentJsonTest::sceneAndTargets() {
    TRY_CHANGE(scene.name, QStringLiteral("\\ \" \t 日本 \U0001F600"));
    TRY_CHANGE(scene.floorHeight, -0.0f);
    TRY_CHANGE(scene.lightSpace.centre, glm::vec3(1e-40f, -0.0f, 3.0e38f));
    TRY_CHANGE(scene.lightSpace.extent, 0.1f);
    TRY_CHANGE(scene.coverTexture, 4096);
    TRY_CHANGE(targets[2].id, TargetId{2'000'000'000u});
    TRY_CHANGE(targets[0].name, QStringLiteral("Bär"));
    TRY_CHANGE(targets[0].placement.centre, glm::dvec3(-0.0, 1e-310, 1.0 / 7.0));
    TRY_CHANGE(targets[0].placement.scale, 1.0 / 7.0);
    TRY_CHANGE(targets[0].textures[0].name, "hide.png");
    TRY_CHANGE(targets[0].textures[0].path, QStringLiteral("/tmp/hide.png"));
    TRY_CHANGE(targets[0].textures[0].relativePath, QStringLiteral("hide.png"));
    TRY_CHANGE(targets[0].transform.position, glm::vec3(0.3f, -0.0f, 1e-42f));
    TRY_CHANGE(targets[0].transform.rotation, glm::quat(0.0f, -0.6f, 0.8f, -0.0f));
    TRY_CHANGE(targets[0].visible, false);
    TRY_CHANGE(targets[0].physics.isDynamic, true);
    TRY_CHANGE(targets[0].physics.mass, 0.1f);
    TRY_CHANGE(targets[0].physics.friction, 0.11f);
    TRY_CHANGE(targets[0].physics.restitution, 0.12f);
}

void DocumentJsonTest::sources() {
    const auto file = std::get<MeshFile>(exampleDocument().targets[0].source.mesh);
    TRY_CHANGE(targets[0].source.relativePath, QStringLiteral("lions/lion.obj"));
    TRY_CHANGE(targets[0].source.mesh, MeshFile{QStringLiteral("/x"), file.size, file.sha256});
    TRY_CHANGE(targets[0].source.mesh, MeshFile{file.path, ~std::uint64_t{0}, file.sha256});
    TRY_CHANGE(targets[0].source.mesh, MeshFile{file.path, file.size, std::string(64, '0')});
    TRY_CHANGE(targets[0].source.mesh, MeshFile{file.path, file.size, {}});
    TRY_CHANGE(targets[2].source.mesh, TargetSource());
    for (int kind = 0; kind < 7; ++kind) {
        TRY_CHANGE(targets[2].source.mesh, Primitive{static_cast<PrimitiveKind>(kind), 24, 0.1f});
    }
    TRY_CHANGE(targets[1].source.mesh, Primitive{PrimitiveKind::Torus, 61, 2.5f});
    TRY_CHANGE(targets[1].source.mesh, Primitive{PrimitiveKind::Torus, 60, 0.3f});
    for (int mesh = 0; mesh < 7; ++mesh) {
        TRY_CHANGE(targets[1].source.mesh, static_cast<BuiltInMesh>(mesh));
    }
}

void DocumentJsonTest::hits() {
    TRY_CHANGE(hits[0].target, TargetId{3});
    TRY_CHANGE(hits[0].point, glm::vec3(0.1f, 0.2f, 0.3f));
    TRY_CHANGE(hits[0].direction, glm::vec3(0.8f, 0.0f, 0.6f));
    TRY_CHANGE(hits[0].constants.maxDistance, 0.1f);
    TRY_CHANGE(hits[0].constants.power, 0.3f);
    TRY_CHANGE(hits[0].constants.maxMagnitude, 0.7f);
    TRY_CHANGE(hits[0].time, 0.1);
    TRY_CHANGE(hits[0].speed, 0.1f);
    TRY_CHANGE(hits[0].impulse, 0.2f);
    TRY_CHANGE(hits[0].enabled, false);
    TRY_CHANGE(hits[0].normal, glm::vec3(0.0f));
    TRY_CHANGE(hits[0].triangle, kNoIndex);
    TRY_CHANGE(hits[0].flight, glm::vec3(0.0f, 0.0f, -1.0f));
    TRY_CHANGE(hits[0].form.profile, DentProfile::Crater);
    TRY_CHANGE(hits[0].form.direction, DentDirection::IntoSurface);
    const DentForm press{.radius = 0.123f, .direction = DentDirection::Press};
    TRY_CHANGE(hits[0].form, press);
    const DentForm curve{.curve = {1.0f, 0.1f, -0.3f, 0.7f, -1.0f, 0.0f, 1e-5f, 0.9f},
                         .profile = DentProfile::Curve};
    TRY_CHANGE(hits[0].form, curve);
    TRY_CHANGE(hits[0].group, (HitGroup{4, HitGroupKind::Stroke}));
    for (const int pipeline : {0, 1, 2, 4, 5, 200, 254, 255}) {
        TRY_CHANGE(hits[0].pipeline, static_cast<std::uint8_t>(pipeline));
    }
}

void DocumentJsonTest::settings() {
    TRY_CHANGE(constants.constants.maxDistance, 0.51f);
    TRY_CHANGE(constants.constants.power, 0.06f);
    TRY_CHANGE(constants.constants.maxMagnitude, 0.31f);
    TRY_CHANGE(constants.relative, false);
    TRY_CHANGE(constants.form.profile, DentProfile::Wendland);
    TRY_CHANGE(constants.form.direction, DentDirection::Press);
    TRY_CHANGE(constants.form.curve[3], -0.125f);
    TRY_CHANGE(projectile.radius, 0.2f);
    TRY_CHANGE(projectile.radius, 1.0e-7f);  // the end of the range, as a float
    TRY_CHANGE(projectile.mass, 1.1f);
    TRY_CHANGE(projectile.speed, 1.2f);
    TRY_CHANGE(projectile.lifetime, 1.3f);
    TRY_CHANGE(projectile.bouncesCount, true);
    TRY_CHANGE(projectile.rateOfFire, 1.4f);
    TRY_CHANGE(projectile.mostAlive, 4999);
    TRY_CHANGE(projectile.powerFollowsImpulse, true);
    TRY_CHANGE(projectile.referenceImpulse, 1.5f);
    TRY_CHANGE(projectile.colour, glm::vec3(0.1f, 0.2f, 0.3f));
    TRY_CHANGE(projectile.gravity, 1.6f);
    TRY_CHANGE(projectile.passesOthers, true);
    for (const PipelineTraits& traits : allPipelines()) {
        if (traits.kind != PipelineKind::TransformFeedback) {
            TRY_CHANGE(simulation.pipeline, traits.kind);
        }
    }
    TRY_CHANGE(simulation.flight, FlightMode::Instant);
    TRY_CHANGE(simulation.flight, FlightMode::Paper);
    TRY_CHANGE(simulation.flight, FlightMode::Own);
    TRY_CHANGE(simulation.physicsStep, 1.0 / 300.0);
    TRY_CHANGE(simulation.timeScale, 0.1);
    TRY_CHANGE(simulation.paused, true);
    TRY_CHANGE(simulation.time, 1234.5678901234567);
}

void DocumentJsonTest::lights() {
    tryTerms(
        "directional", [](auto& d) -> auto& { return d.lights.directional; });
    TRY_CHANGE(lights.directional.direction, glm::vec3(1.0f, 0.0f, -0.0f));
    for (std::size_t i = 0; i < 4; ++i) {
        tryPlaced(
            "point", [i](auto& d) -> auto& { return d.lights.points[i]; });
    }
    tryPlaced(
        "spot", [](auto& d) -> auto& { return d.lights.spot; });
    TRY_CHANGE(lights.spot.atEye, false);
    TRY_CHANGE(lights.spot.direction, glm::vec3(0.1f, 0.2f, 0.3f));
    TRY_CHANGE(lights.spot.innerAngle, 0.1f);
    TRY_CHANGE(lights.spot.outerAngle, 0.7f);
}

void DocumentJsonTest::display() {
    Camera camera;
    camera.setPivot({0.1f, -0.0f, 3.0f}, 0.3f, 0.2f, 7.7f);
    TRY_CHANGE(cameras.current, "");
    TRY_CHANGE(cameras.current, cameraText(camera));
    TRY_CHANGE(cameras.kept[0], cameraText(camera));
    TRY_CHANGE(display.wireframe, WireframeMode::Over);
    TRY_CHANGE(display.wireframe, WireframeMode::Only);
    TRY_CHANGE(display.normals, NormalMode::Paper);
    TRY_CHANGE(display.look, SurfaceLook::Matcap);
    TRY_CHANGE(display.look, SurfaceLook::Metal);
    for (bool DisplayOptions::*option :
         {&DisplayOptions::floor, &DisplayOptions::textures, &DisplayOptions::vertexColours,
          &DisplayOptions::crosshair, &DisplayOptions::sideBySide, &DisplayOptions::flat,
          &DisplayOptions::needles, &DisplayOptions::dots, &DisplayOptions::backFaces,
          &DisplayOptions::shadows, &DisplayOptions::environment}) {
        tryChange(
            "switch", [option](auto& d) -> auto& { return d.display.*option; },
            !(exampleDocument().display.*option));
    }
    TRY_CHANGE(display.beforeAfter.ghost, GhostMode::Wire);
    TRY_CHANGE(display.beforeAfter.ghost, GhostMode::Translucent);
    TRY_CHANGE(display.beforeAfter.wipe, true);
    TRY_CHANGE(display.beforeAfter.wipeAt, 0.1f);
    TRY_CHANGE(display.beforeAfter.exaggeration, 3.3f);
    TRY_CHANGE(display.cut.on, true);
    TRY_CHANGE(display.cut.normal, glm::vec3(-0.6f, 0.0f, 0.8f));
    TRY_CHANGE(display.cut.offset, -0.1f);
    TRY_CHANGE(display.cut.flipped, true);
    TRY_CHANGE(display.cut.originalLine, false);
    TRY_CHANGE(display.cut.deformedLine, false);
    TRY_CHANGE(display.cut.fill, true);
    TRY_CHANGE(display.change.on, true);
    TRY_CHANGE(display.change.isolines, true);
    for (int i = 0; i < kChangeQuantities; ++i) {
        if (i > 0) {
            TRY_CHANGE(display.change.quantity, static_cast<ChangeQuantity>(i));
        }
        const auto style = [i](auto& d) -> auto& {
            return d.display.change.styles[static_cast<std::size_t>(i)];
        };
        tryChange(
            "map", [&](auto& d) -> auto& { return style(d).map; }, ColourMap::Cividis);
        tryChange(
            "automatic", [&](auto& d) -> auto& { return style(d).automatic; }, false);
        tryChange(
            "low", [&](auto& d) -> auto& { return style(d).fixed.low; }, -3000.5f);
        tryChange(
            "high", [&](auto& d) -> auto& { return style(d).fixed.high; }, 3000.1f);
    }
}

void DocumentJsonTest::selection() {
    TRY_CHANGE(selection.target, TargetId{});
    TRY_CHANGE(selection.hit, std::optional<std::size_t>());
    TRY_CHANGE(selection.hit, std::optional<std::size_t>(0));
    TRY_CHANGE(selection.shown, std::optional<std::size_t>());
    TRY_CHANGE(selection.shown, std::optional<std::size_t>(0));
    TRY_CHANGE(selection.picked, std::optional<VertexRef>());
    TRY_CHANGE(selection.picked, std::optional(VertexRef{TargetId{3}, 12}));
    TRY_CHANGE(selection.picked, std::optional(VertexRef{TargetId{1}, 0xfffffffeu}));
    TRY_CHANGE(selection.vertices[0].target, TargetId{3});
    TRY_CHANGE(selection.vertices[0].vertices, std::vector<std::uint32_t>{0, 0xfffffffeu});
    TRY_CHANGE(positions[1].target, TargetId{3});
    TRY_CHANGE(positions[1].fingerprint, ~std::uint64_t{0});
}

void DocumentJsonTest::eachHitHasALine() {
    const SessionDocument document = exampleDocument();
    SessionDocument more = document;
    more.hits.insert(more.hits.begin() + 1, exampleHit(3, 9.0f));
    const QList<QByteArray> before = writeDocument(document).split('\n');
    QList<QByteArray> after = writeDocument(more).split('\n');
    QCOMPARE(after.size(), before.size() + 1);
    qsizetype at = 0;
    while (at < before.size() && before[at] == after[at]) {
        ++at;
    }
    QVERIFY(after[at].contains("\"point\": [9, 0.1, -2.5]"));
    after.removeAt(at);
    QCOMPARE(after, before);
}

/// What a file does not say is as in a new document, and what is not known is passed over.
void DocumentJsonTest::olderFilesOpen() {
    const Result<SessionDocument> little = readDocument(
        "{\"format\": \"hitscope session\", \"version\": 1, \"mood\": {\"a\": [1]},"
        "\"targets\": [{\"id\": 2, \"weight\": 5, \"source\": {\"kind\": \"primitive\", \"shape\": "
        "\"cube\"}}],"
        "\"hits\": [{\"target\": 2, \"point\": [1, 2, 3], \"direction\": [0, 0, 1]}]}");
    QVERIFY2(little.ok(), qPrintable(messageOf(little)));
    QCOMPARE(little.value().hits.size(), std::size_t(1));
    QVERIFY(little.value().hits[0].constants == DeformationConstants());
    QVERIFY(little.value().lights == Lights());
    QVERIFY(readDocument("\xef\xbb\xbf" + writeDocument(exampleDocument())).ok());
}

/// Does not compile where a type has come to have one more member: it belongs into the file, and above.
void DocumentJsonTest::membersAreKnown() {
    [[maybe_unused]] const auto& [h1, h2, h3, h4, h5, h6, h7, h8, h9, h10, h11, h12, h13, h14] = Hit();
    [[maybe_unused]] const auto& [p1, p2, p3, p4, p5, p6, p7, p8, p9, p10, p11, p12, p13] =
        ProjectileSettings();
    [[maybe_unused]] const auto& [d1, d2, d3, d4, d5, d6, d7, d8, d9, d10, d11, d12, d13, d14, d15, d16, d17,
                                  d18, d19, d20, d21] = DisplayOptions();
    [[maybe_unused]] const auto& [b1, b2, b3, b4] = BeforeAfterOptions();
    [[maybe_unused]] const auto& [c1, c2, c3, c4] = ChangeMapOptions();
    [[maybe_unused]] const auto& [cut1, cut2, cut3, cut4, cut5, cut6, cut7] = CuttingPlane();
    [[maybe_unused]] const auto& [q1, q2, q3] = QuantityStyle();
    [[maybe_unused]] const auto& [l1, l2, l3] = Lights();
    [[maybe_unused]] const auto& [s1, s2, s3, s4, s5, s6, s7, s8] = SpotLight();
    [[maybe_unused]] const auto& [point1, point2, point3, point4] = PointLight();
    [[maybe_unused]] const auto& [sun1, sun2, sun3] = DirectionalLight();
    [[maybe_unused]] const auto& [t1, t2, t3, t4] = LightTerms();
    [[maybe_unused]] const auto& [physics1, physics2, physics3, physics4] = TargetPhysics();
    [[maybe_unused]] const auto& [constants1, constants2, constants3] = DeformationConstants();
    [[maybe_unused]] const auto& [setting1, setting2, setting3] = ConstantsSetting();
    [[maybe_unused]] const auto& [form1, form2, form3, form4] = DentForm();
    [[maybe_unused]] const auto& [placement1, placement2] = Placement();
}

HITSCOPE_TEST(DocumentJsonTest, QCoreApplication)

}  // namespace hitscope::document_json_test

#include "document_json_test.moc"
