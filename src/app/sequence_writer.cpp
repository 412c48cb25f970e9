// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sequence_writer.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "io/save_image.h"
#include "viewport/viewport.h"

namespace hitscope {

namespace {

constexpr int kMostWaiting = 4;  // pictures drawn and not yet written: they take memory

}  // namespace

SequenceWriter::SequenceWriter(Viewport& viewport, QObject* parent) : QObject(parent), m_viewport(viewport) {
    // A sequence's own buffers go with the context.
    connect(&viewport.scene(), &ViewportScene::aboutToRelease, this, &SequenceWriter::cancel);
}

SequenceWriter::~SequenceWriter() {
    stop();
    m_writers.waitForDone();
}

Status SequenceWriter::start(const Plan& plan) {
    stop();
    m_plan = plan;
    m_drawn = 0;
    m_samples = 0;
    m_written = 0;
    m_waiting = 0;
    m_problem.reset();
    ++m_run;
    Status made = m_viewport.scene().with([this](SceneGpu& scene) -> Status {
        if (m_plan.turntable > 0) {
            m_sequence = PictureSequence::turntable(scene, m_plan.picture, m_plan.turntable);
            return Done{};
        }
        Result<PictureSequence> replay = PictureSequence::replay(m_viewport.session(), m_plan.picture);
        if (!replay) {
            return replay.error();
        }
        m_sequence = std::move(replay).value();
        return Done{};
    });
    if (made) {
        m_count = m_sequence->count();
        stepSoon();
    }
    return made;
}

/// One at a time: what else the window does has its turn between two.
void SequenceWriter::stepSoon() {
    if (!std::exchange(m_isStepPosted, true)) {
        QTimer::singleShot(0, this, &SequenceWriter::step);
    }
}

void SequenceWriter::step() {
    m_isStepPosted = false;
    if (!isRunning() || m_drawn >= m_count || m_waiting >= kMostWaiting) {
        return;  // took() goes on
    }
    Status drawn = m_viewport.scene().with([this](SceneGpu&) -> Status {
        Result<std::optional<Image>> image = m_sequence->advance();
        if (!image) {
            return image.error();
        }
        if (image.value()) {
            ++m_drawn;
            write(*image.value());
        }
        return Done{};
    });
    if (!drawn) {
        m_problem = drawn.error();
        stop();
        finish();
        return;
    }
    stepSoon();
    if (const int each = m_plan.picture.samples; each > 1) {
        // A picture may begin anew.
        m_samples = std::min(std::max(m_samples + 1, m_drawn * each), (m_drawn + 1) * each);
        Q_EMIT sampled(m_samples, each * m_count);
    }
}

void SequenceWriter::write(const Image& image) {
    const QString path =
        !m_plan.path.isEmpty() ? m_plan.path : sequencePath(m_plan.folder, m_plan.base, m_drawn, m_count);
    ++m_waiting;
    m_writers.start([this, image, path, run = m_run] {
        const Status saved = savePicture(image, path);
        QMetaObject::invokeMethod(
            this, [this, run, saved] { took(run, saved); }, Qt::QueuedConnection);
    });
}

void SequenceWriter::took(int run, const Status& saved) {
    if (run != m_run) {
        return;
    }
    --m_waiting;
    if (saved) {
        ++m_written;
    } else {
        m_problem = m_problem ? m_problem : saved.error();
        stop();
    }
    if (!isRunning()) {
        finish();
        return;
    }
    Q_EMIT progressed(m_written, m_count);
    if (run != m_run || !isRunning()) {
        return;  // who shows it handled events, among them the last picture or a click on Cancel
    }
    if (m_written == m_count) {
        stop();
        finish();
    } else {
        stepSoon();
    }
}

void SequenceWriter::cancel() {
    if (isRunning()) {
        stop();
        finish();
    }
}

/// Once what was drawn is written, which took() calls it for again.
void SequenceWriter::finish() {
    if (m_waiting > 0) {
        return;
    }
    if (m_problem) {
        Q_EMIT failed(Error(*m_problem));  // a copy: the next run may begin meanwhile
    } else {
        Q_EMIT ended(m_written);
    }
}

void SequenceWriter::stop() {
    if (m_sequence) {
        // Its buffers are given back where they came from.
        static_cast<void>(m_viewport.scene().with([this](SceneGpu&) -> Status {
            m_sequence.reset();
            return Done{};
        }));
        m_sequence.reset();
    }
}

}  // namespace hitscope
