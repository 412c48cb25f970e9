// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/cost_measurement.h"

#include <QThread>
#include <utility>

#include "session/session.h"

namespace hitscope {

namespace {

ScenePlan planOf(const Session& session) {
    ScenePlan plan;
    plan.floorHeight = session.targets().floorHeight();
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (target->visible && !target->deformed.vertices().empty()) {
            plan.targets.push_back({target->name, target->shape, target->transform, *target->collider, {}});
        }
    }
    return plan;
}

}  // namespace

CostMeasurement::CostMeasurement(CostMeter meter, QObject* parent)
    : QObject(parent), m_meter(std::move(meter)) {}

CostMeasurement::~CostMeasurement() {
    if (m_thread != nullptr) {
        m_cancelled->store(true);
        m_thread->wait();
        delete m_thread;
    }
}

void CostMeasurement::start(const Session& session, const Camera& camera, CostPlan plan) {
    auto order =
        std::make_shared<const CostOrder>(CostOrder{planOf(session), session.settings().constants(),
                                                    session.settings().lights(), camera, std::move(plan)});
    run([order, measure = m_meter.scene](const std::atomic<bool>& cancelled,
                                         const CostMeter::Report& report) {
        return measure(*order, cancelled, report);
    });
}

void CostMeasurement::start(SizePlan plan) {
    run([plan = std::move(plan), measure = m_meter.sizes](const std::atomic<bool>& cancelled,
                                                          const CostMeter::Report& report) {
        return measure(plan, cancelled, report);
    });
}

void CostMeasurement::run(Measure measure) {
    if (m_thread != nullptr) {
        cancel();
        end();
    }
    m_curves.clear();
    m_cancelled = std::make_shared<std::atomic<bool>>(false);
    // What arrives from a measurement that was cancelled is not of this one.
    const auto whenCurrent = [this, mine = m_cancelled](auto act) {
        QMetaObject::invokeMethod(this, [this, mine, act] {
            if (mine == m_cancelled) {
                act();
            }
        });
    };
    m_thread = QThread::create([this, measure = std::move(measure), whenCurrent, cancelled = m_cancelled] {
        const Status status = measure(*cancelled, [&](const CostSample& sample, int done, int total) {
            whenCurrent([this, sample, done, total] {
                m_curves.addFrame(sample.pipeline, sample.at, sample.frame);
                m_curves.addHit(sample.pipeline, sample.at, sample.hit);
                Q_EMIT progressed(done + 1, total);
            });
        });
        whenCurrent([this, status] {
            end();
            if (!status) {
                Q_EMIT failed(QString::fromStdString(status.error().message()));
            }
            Q_EMIT finished();
        });
    });
    m_thread->start(QThread::LowPriority);
}

void CostMeasurement::cancel() {
    if (m_cancelled) {
        m_cancelled->store(true);
    }
}

void CostMeasurement::end() {
    m_thread->wait();
    m_thread->deleteLater();
    m_thread = nullptr;
}

}  // namespace hitscope
