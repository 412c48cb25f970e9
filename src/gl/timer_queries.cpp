// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/timer_queries.h"

#include <algorithm>

namespace hitscope::gl {

namespace {

constexpr double kNanosecond = 1.0e-9;  // seconds

GLuint64 resultOf(const Query& query) {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(query.id(), GL_QUERY_RESULT, &nanoseconds);
    return nanoseconds;
}

bool hasArrived(const Query& query) {
    GLuint available = GL_FALSE;
    glGetQueryObjectuiv(query.id(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available != GL_FALSE;
}

}  // namespace

bool TimerQueries::isAvailable() {
    if (epoxy_gl_version() < 33 && !epoxy_has_gl_extension("GL_ARB_timer_query")) {
        return false;
    }
    GLint bits = 0;  // a driver may have the functions and no clock
    glGetQueryiv(GL_TIMESTAMP, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0;
}

TimerQueries::TimerQueries(std::size_t frames, std::size_t marks)
    : m_slots(std::max<std::size_t>(frames, 1)) {
    for (Slot& made : m_slots) {
        made.queries.resize(std::max<std::size_t>(marks, 2));
        std::generate(made.queries.begin(), made.queries.end(), [] { return Query::make(); });
    }
}

bool TimerQueries::begin(std::uint64_t frame) {
    end();
    if (m_pending == m_slots.size()) {
        return false;
    }
    m_open = &slot(m_pending);
    m_open->frame = frame;
    m_open->marks = 0;
    mark();
    return true;
}

void TimerQueries::mark() {
    if (m_open != nullptr && m_open->marks < m_open->queries.size()) {
        glQueryCounter(m_open->queries[m_open->marks].id(), GL_TIMESTAMP);
        ++m_open->marks;
    }
}

void TimerQueries::end() {
    if (m_open != nullptr) {
        m_open = nullptr;
        ++m_pending;
    }
}

void TimerQueries::poll(std::size_t notYet, const Sink& sink) {
    std::vector<double> seconds;
    while (m_pending > notYet) {
        const Slot& oldest = slot(0);
        if (!hasArrived(oldest.queries[oldest.marks - 1])) {
            return;
        }
        seconds.clear();
        GLuint64 before = resultOf(oldest.queries[0]);
        for (std::size_t i = 1; i < oldest.marks; ++i) {
            const GLuint64 passed = resultOf(oldest.queries[i]);
            seconds.push_back(passed > before ? static_cast<double>(passed - before) * kNanosecond : 0.0);
            before = std::max(before, passed);
        }
        const std::uint64_t frame = oldest.frame;
        m_first = (m_first + 1) % m_slots.size();
        --m_pending;
        sink(frame, seconds);
    }
}

}  // namespace hitscope::gl
