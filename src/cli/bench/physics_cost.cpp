// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/physics_cost.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "cli/bench/random_hits.h"
#include "cli/bench/sphere.h"
#include "deform/reference.h"
#include "physics/physics_world.h"

namespace hitscope::bench {

namespace {

constexpr TargetId kTarget{1};
constexpr std::uint32_t kPhysicsSeed = 1;
constexpr int kVolley = 1;  // they pass through each other: only the target is struck
constexpr int kStepsOfFlight = 60;
constexpr std::size_t kHitsASample = 16;

ProjectileSettings settings() {
    ProjectileSettings settings;
    settings.mostAlive = kProjectiles;
    return settings;
}

Status place(PhysicsWorld& world, const PreparedMesh& mesh, bool isDynamic) {
    TargetPhysics physics;
    physics.isDynamic = isDynamic;
    return world.addTarget(kTarget, {}, MeshCollider{mesh.collision}, physics);
}

/// Two thousand projectiles and a target, both ways.
class Volley {
public:
    explicit Volley(const PreparedMesh& mesh) : m_mesh(mesh) {}

    Status open() { return place(m_world, m_mesh, false); }

    /// Beside the target, in parallel.
    Status prepareFlight() {
        if (m_stepsLeft > 0) {
            return Done{};
        }
        m_stepsLeft = kStepsOfFlight;
        m_world.removeProjectiles();
        constexpr int kRow = 50;
        for (int i = 0; i < kProjectiles; ++i) {
            const glm::vec3 origin(0.3f * static_cast<float>(i % kRow),
                                   5.0f + 0.3f * static_cast<float>(i / kRow), 3.0f * kSphereRadius);
            m_world.shoot(origin, {1.0f, 0.0f, 0.0f}, settings(), kVolley);
        }
        return Done{};
    }
    Status fly() {
        --m_stepsLeft;
        return m_world.takeStep().empty() ? Status(Done{})
                                          : Status(Error{"A projectile beside the target hit it.", "", ""});
    }

    /// From all around, half a step's flight away, spread evenly by the golden angle.
    Status prepareStrike() {
        m_stepsLeft = 0;
        m_world.removeProjectiles();
        const ProjectileSettings shot = settings();
        const float away =
            kSphereRadius + shot.radius + 0.5f * shot.speed * static_cast<float>(StepClock::kStep);
        for (int i = 0; i < kProjectiles; ++i) {
            const float height = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / kProjectiles;
            const float across = std::sqrt(1.0f - height * height);
            const float turn = 2.3999632f * static_cast<float>(i);
            const glm::vec3 outwards(across * std::cos(turn), height, across * std::sin(turn));
            m_world.shoot(away * outwards, -outwards, shot, kVolley);
        }
        return Done{};
    }
    Status strike() {
        return m_world.takeStep().size() == kProjectiles
                   ? Status(Done{})
                   : Status(Error{"Not all projectiles struck.", "", ""});
    }

private:
    const PreparedMesh& m_mesh;
    PhysicsWorld m_world;
    int m_stepsLeft = 0;
};

/// A target that is hit again and again, its collider following. It is whole before each sample: hits come
/// to where the original surface is, and on a small mesh they soon find nothing there.
class DentedTarget {
public:
    DentedTarget(const PreparedMesh& mesh, bool isDynamic)
        : m_mesh(mesh),
          m_isDynamic(isDynamic),
          m_hits({{kTarget, mesh.render.get()}},
                 constantsReaching(kDentVertices, static_cast<double>(mesh.render->vertices.size()),
                                   static_cast<double>(kSphereRadius)),
                 kPhysicsSeed) {}

    Status open() {
        makeWhole();
        return place(m_world, m_mesh, m_isDynamic);
    }

    Status prepare() {
        makeWhole();
        m_world.resetTarget(kTarget);
        static_cast<void>(m_world.takeStep());  // the hull follows
        m_moved.clear();
        for (const Hit& hit : m_hits.next(kHitsASample)) {
            m_moved.push_back(m_shape->apply({&hit, 1}));
        }
        return Done{};
    }
    Status follow() {
        for (const std::vector<VertexRange>& ranges : m_moved) {
            for (const VertexRange& range : ranges) {
                m_world.updateTarget(kTarget, range.first, m_shape->vertices(range));
            }
            if (m_isDynamic) {
                static_cast<void>(m_world.takeStep());
            }
        }
        return Done{};
    }

private:
    void makeWhole() { m_shape = std::make_unique<ReferenceDeformation>(*m_mesh.render); }

    const PreparedMesh& m_mesh;
    bool m_isDynamic;
    RandomHits m_hits;
    PhysicsWorld m_world;
    std::unique_ptr<ReferenceDeformation> m_shape;
    std::vector<std::vector<VertexRange>> m_moved;  ///< by each hit of the sample
};

/// One mesh in all situations that are measured.
struct Situations {
    std::optional<Volley> volley;
    std::unique_ptr<DentedTarget> still;
    std::unique_ptr<DentedTarget> moving;

    Status open(const PreparedMesh& mesh, bool withVolley) {
        still = std::make_unique<DentedTarget>(mesh, false);
        moving = std::make_unique<DentedTarget>(mesh, true);
        Status status = still->open();
        if (status) {
            status = moving->open();
        }
        if (status && withVolley) {
            status = volley.emplace(mesh).open();
        }
        return status;
    }

    void addVariants(std::vector<Variant>& variants) {
        for (DentedTarget* target : {still.get(), moving.get()}) {
            variants.push_back({"collider", static_cast<double>(kHitsASample),
                                [target] { return target->prepare(); },
                                [target] { return target->follow(); }});
        }
        if (volley) {
            Volley* shots = &*volley;
            variants.push_back({"in flight", 1.0, [shots] { return shots->prepareFlight(); },
                                [shots] { return shots->fly(); }});
            variants.push_back({"striking", 1.0, [shots] { return shots->prepareStrike(); },
                                [shots] { return shots->strike(); }});
        }
    }
};

Result<std::vector<PhysicsFigure>> measureAll(const BenchRoom& room, const std::vector<PreparedMesh>& meshes,
                                              const Plan& plan, bool withVolley) {
    std::vector<std::unique_ptr<Situations>> situations;
    std::vector<Variant> variants;
    for (const PreparedMesh& mesh : meshes) {
        situations.push_back(std::make_unique<Situations>());
        if (Status status = situations.back()->open(mesh, withVolley); !status) {
            return status.error();
        }
        situations.back()->addVariants(variants);
    }
    Result<std::vector<Samples>> samples = room.measure(QStringLiteral("physics"), variants, plan);
    if (!samples) {
        return samples.error();
    }
    std::vector<PhysicsFigure> figures;
    auto next = samples.value().begin();
    for (const PreparedMesh& mesh : meshes) {
        PhysicsFigure figure;
        figure.triangles = mesh.render->triangles.size() / 3;
        figure.dented = *next++;
        figure.dentedMoving = *next++;
        if (withVolley) {
            figure.flying = *next++;
            figure.striking = *next++;
        }
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace

PreparedMesh physicsSphere(int triangles) {
    return prepareMesh(makeSphere(triangles / 2));
}

Result<std::vector<PhysicsFigure>> measurePhysics(const BenchRoom& room,
                                                  const std::vector<PreparedMesh>& meshes, const Plan& plan) {
    return measureAll(room, meshes, plan, true);
}

Result<std::vector<PhysicsFigure>> measureColliders(const BenchRoom& room,
                                                    const std::vector<PreparedMesh>& meshes,
                                                    const Plan& plan) {
    return measureAll(room, meshes, plan, false);
}

}  // namespace hitscope::bench
