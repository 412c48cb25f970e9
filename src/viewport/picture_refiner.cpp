// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/picture_refiner.h"

#include <algorithm>
#include <utility>

namespace hitscope {

namespace {

// Milliseconds from the beginning to the first look at what there is, and from one to the next. Each takes
// about half as long as a sample.
constexpr int kBetweenLooks = 600;
constexpr int kLookAgain = 1;         // milliseconds, whether the renderer has got far enough
constexpr qint64 kRestForSample = 1;  // times as long as a sample takes, nothing must have happened before it
constexpr qint64 kLongestRest = 1000;  // milliseconds

std::unique_ptr<RefinedView> makeView() {
    return std::make_unique<RefinedView>(RefinedView::Pixels::UntilSettled);
}

}  // namespace

PictureRefiner::PictureRefiner(Hooks hooks, QObject* parent) : QObject(parent), m_hooks(std::move(hooks)) {
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &PictureRefiner::step);
}

PictureRefiner::~PictureRefiner() = default;

void PictureRefiner::setOn(bool on) {
    if (on == m_on) {
        return;
    }
    m_on = on;
    if (!on) {
        releaseGpu();
    } else if (m_whyNot.isEmpty()) {
        m_view = makeView();
    }
}

void PictureRefiner::setWanted(int samples) {
    m_wanted = samples;
    if (m_view && m_view->samples() > samples) {
        m_view = makeView();
    }
}

void PictureRefiner::releaseGpu() {
    m_timer.stop();
    m_view = m_view && m_on ? makeView() : nullptr;
}

bool PictureRefiner::isDone() const {
    return m_view == nullptr || (m_view->samples() >= m_wanted && (m_view->isWhole() || !m_hooks.isCoarse()));
}

void PictureRefiner::framePainted() {
    if (isDone()) {
        m_timer.stop();
    } else if (!m_view->wasShown() || !m_timer.isActive()) {
        m_timer.start(m_view->wasShown() ? 0 : rest());
    }
}

/// Input that comes during a sample waits for it: the longer it takes, the longer nobody has used the window
/// before.
int PictureRefiner::rest() const {
    return static_cast<int>(std::clamp<qint64>(kRestForSample * m_sampleTime, kRest, kLongestRest));
}

void PictureRefiner::inputCame() {
    m_sinceStep.invalidate();
    if (m_timer.isActive()) {
        m_timer.start(rest());
    }
}

void PictureRefiner::step() {
    if (isDone() || !m_hooks.mayRefine()) {
        return;  // the next frame that is painted goes on
    }
    if (m_hooks.isBehind(*m_view)) {
        m_timer.start(kLookAgain);
        return;
    }
    const int before = m_view->samples();
    const bool wasWhole = m_view->isWhole();
    if (before == 0) {
        m_sinceShown.start();
    }
    if (before > 0 && m_sinceStep.isValid()) {
        m_sampleTime = m_sinceStep.elapsed();  // all of the one before, which the driver may have put off
    }
    m_sinceStep.start();
    if (Status added = m_hooks.addSample(*m_view); !added) {
        m_view.reset();
        m_whyNot = QString::fromStdString(added.error().message());
        Q_EMIT failed();
        m_hooks.show();
        return;
    }
    if (m_view == nullptr || !m_view->isPossible()) {
        return;
    }
    const int samples = m_view->samples();
    if (samples > before) {
        Q_EMIT refined(samples);
    }
    const bool isNew = m_sinceShown.elapsed() >= kBetweenLooks;
    const bool isFirst = !wasWhole && m_view->isWhole() && m_hooks.isCoarse();
    if (isDone() || isFirst || (samples >= RefinedView::kFewestShown && isNew)) {
        m_sinceShown.start();
        Q_EMIT aboutToShow();
        m_hooks.show();
    }
    if (!isDone()) {
        m_timer.start(0);
    }
}

}  // namespace hitscope
