// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/timer_queries.h"

#include <QTest>
#include <vector>

#include "gl/render_target.h"
#include "support/gl_fixture.h"
#include "support/test_program.h"

namespace hitscope::timer_queries_test {

namespace {

struct Answer {
    std::uint64_t frame = 0;
    std::vector<double> seconds;
};

std::vector<Answer> take(gl::TimerQueries& timers, std::size_t notYet) {
    std::vector<Answer> answers;
    timers.poll(notYet, [&answers](std::uint64_t frame, std::span<const double> seconds) {
        answers.push_back({frame, {seconds.begin(), seconds.end()}});
    });
    return answers;
}

}  // namespace

class TimerQueriesTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() {
        if (m_gl.open() && !gl::TimerQueries::isAvailable()) {
            QSKIP("The driver has no timer queries.");
        }
    }
    void cleanup() { QCOMPARE(m_gl.errors(), QStringList()); }

    void answersComeInOrder() {
        const gl::RenderTarget target(64, 64);
        gl::TimerQueries timers(4, 3);
        for (std::uint64_t frame = 10; frame < 13; ++frame) {
            QVERIFY(timers.begin(frame));
            glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer());
            glClear(GL_COLOR_BUFFER_BIT);
            timers.mark();
            glClear(GL_COLOR_BUFFER_BIT);
            timers.mark();
            timers.mark();  // one too many
            timers.end();
        }
        QCOMPARE(timers.pending(), std::size_t{3});
        glFinish();
        const std::vector<Answer> answers = take(timers, 1);
        QCOMPARE(answers.size(), std::size_t{2});
        QCOMPARE(answers[0].frame, std::uint64_t{10});
        QCOMPARE(answers[1].frame, std::uint64_t{11});
        QCOMPARE(answers[0].seconds.size(), std::size_t{2});
        for (const double seconds : answers[0].seconds) {
            QVERIFY(seconds >= 0.0 && seconds < 10.0);
        }
        QCOMPARE(timers.pending(), std::size_t{1});
        QCOMPARE(take(timers, 0).size(), std::size_t{1});
        QCOMPARE(take(timers, 0).size(), std::size_t{0});
    }

    void aFullRingMeasuresNothing() {
        gl::TimerQueries timers(2, 2);
        for (std::uint64_t frame = 1; frame <= 4; ++frame) {
            QCOMPARE(timers.begin(frame), frame <= 2);
            timers.mark();
            timers.end();
        }
        glFinish();
        const std::vector<Answer> answers = take(timers, 0);
        QCOMPARE(answers.size(), std::size_t{2});
        QCOMPARE(answers[1].frame, std::uint64_t{2});
        QVERIFY(timers.begin(5));
        timers.end();
        glFinish();
        const std::vector<Answer> alone = take(timers, 0);
        QCOMPARE(alone.size(), std::size_t{1});
        QVERIFY(alone[0].seconds.empty());
    }

    void marksOutsideOfFramesAreNone() {
        gl::TimerQueries timers(2, 2);
        timers.mark();
        timers.end();
        QCOMPARE(timers.pending(), std::size_t{0});
    }

private:
    test::GlFixture m_gl;
};

HITSCOPE_TEST(TimerQueriesTest, QCoreApplication)

}  // namespace hitscope::timer_queries_test

#include "timer_queries_test.moc"
