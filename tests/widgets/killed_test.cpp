// SPDX-License-Identifier: GPL-3.0-or-later
// The window is killed while somebody works in it: what can be recovered is what there was, but for the last
// moment. HITSCOPE_KILLS: how often, instead of twice; then the last second is all that may be missing.
#include <QApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>

#include "app/session_files.h"
#include "deform/fingerprint.h"
#include "document/capture.h"
#include "document/document_json.h"
#include "document/journal_files.h"
#include "document/journal_records.h"
#include "document/session_file.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::killed_test {

namespace {

constexpr const char* kFolder = "HITSCOPE_KILLED_FOLDER";  // that the window which is killed works in
constexpr double kLongest = 10.0;                          // seconds; a busy machine's disk

/// The same clock in both processes.
double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A session in two parts, which come to the journal one after the other.
struct State {
    double at = 0.0;  ///< seconds, now()
    QByteArray hits;
    QByteArray others;
};

State stateOf(SessionDocument document) {
    std::vector<TargetId> ids;
    for (const SavedTarget& target : document.targets) {
        ids.push_back(target.id);
    }
    State state;
    state.at = now();
    state.hits = QByteArray::number(static_cast<quint64>(hitsFingerprint(document.hits, ids)), 16);
    numberTargets(1, document);
    document.hits.clear();
    document.positions.clear();
    document.selection = {};
    document.cameras = {};
    document.display = {};
    document.simulation.time = 0.0;
    for (SavedTarget& target : document.targets) {
        target.source.relativePath.clear();
    }
    state.others =
        QCryptographicHash::hash(writeDocument(document), QCryptographicHash::Sha1).toHex().left(16);
    return state;
}

/// Those that the window said it had, in their order.
std::vector<State> statesIn(const QByteArray& output) {
    std::vector<State> states;
    for (const QByteArray& line : output.split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (words.size() == 5 && words[0] == "state" && words[4] == ".") {
            states.push_back({words[1].toDouble(), words[2], words[3]});
        }
    }
    return states;
}

/// How long before `end` there was something that is not in what was found; nothing: it never was a state.
std::optional<double> missing(const std::vector<State>& states, QByteArray State::*part,
                              const QByteArray& found, double end) {
    const auto last = std::find_if(states.rbegin(), states.rend(),
                                   [&](const State& state) { return state.*part == found; });
    if (last == states.rend()) {
        return std::nullopt;
    }
    const auto next =
        std::find_if(last.base(), states.end(), [&](const State& state) { return state.*part != found; });
    return next == states.end() ? 0.0 : end - next->at;
}

}  // namespace

class KilledTest : public QObject, private WindowFixture {
    Q_OBJECT
public:
    static void initMain() { MainWindow::setSurfaceFormat(); }

private Q_SLOTS:
    void losesTheLastMomentAtMost() {
        if (qEnvironmentVariableIsSet(kFolder)) {
            work(qEnvironmentVariable(kFolder));
            return;
        }
        bool isChosen = false;
        const int chosen = qEnvironmentVariableIntValue("HITSCOPE_KILLS", &isChosen);
        double latest = 0.0;
        for (int kill = 0; kill < (isChosen ? chosen : 2); ++kill) {
            killOne(isChosen ? 1.0 : kLongest, latest);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        std::printf("# missing at most: %.3f s\n", latest);
    }

private:
    static void killOne(double longest, double& latest) {
        const QTemporaryDir folder;
        QProcess window;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QLatin1String(kFolder), folder.path());
        window.setProcessEnvironment(environment);
        window.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        window.start(QCoreApplication::applicationFilePath(),
                     {QStringLiteral("killed"), QStringLiteral("losesTheLastMomentAtMost")});
        QByteArray output;
        while (!output.contains("state ") && window.state() != QProcess::NotRunning) {
            QVERIFY(window.waitForReadyRead(kPatience));
            output += window.readAllStandardOutput();
        }
        const int lives = QRandomGenerator::global()->bounded(100, 4000);
        const double until = now() + 1.0e-3 * lives;
        while (now() < until) {
            window.waitForReadyRead(std::max(1, static_cast<int>(1000.0 * (until - now()))));
            output += window.readAllStandardOutput();
        }
        QCOMPARE(window.state(), QProcess::Running);
        const double end = now();
        window.kill();
        QVERIFY(window.waitForFinished(kPatience));
        output += window.readAllStandardOutput();

        const std::vector<State> states = statesIn(output);
        State found;
        find(folder.path(), states, found);
        if (QTest::currentTestFailed()) {
            return;
        }
        for (const auto part : {&State::hits, &State::others}) {
            const std::optional<double> seconds = missing(states, part, found.*part, end);
            QVERIFY2(seconds, "what was recovered never was");
            QVERIFY2(*seconds <= longest, qPrintable(QString::number(*seconds)));
            latest = std::max(latest, *seconds);
        }
    }

    /// What a person gets back: from the journal, else from the file.
    static void find(const QString& folder, const std::vector<State>& states, State& found) {
        const QString file = QDir(folder).filePath(QStringLiteral("work.hitscope"));
        QVERIFY(!states.empty());
        found = states.front();
        if (QFile::exists(file)) {
            const Result<SessionDocument> saved = readSessionFile(file);
            QVERIFY2(saved.ok(), "the saved file is damaged");
            found = stateOf(saved.value());
        }
        const std::vector<FoundJournal> journals =
            findJournals(QDir(folder).filePath(QStringLiteral("hitscope/journals")));
        QVERIFY(journals.size() <= 1);
        if (!journals.empty()) {
            const Result<ClaimedJournal> journal = ClaimedJournal::claim(journals.front().path);
            QVERIFY(journal.ok());
            const Result<RecoveredJournal> read = readJournal(journal.value().read().value());
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().message().c_str());
            QVERIFY(read.value().droppedHits == 0);
            found = stateOf(read.value().document);
        }
    }

    /// Shoots, edits and saves until it is killed.
    void work(const QString& folder) {
        m_settings = std::make_unique<TestSettings>();
        qputenv("XDG_STATE_HOME", folder.toLocal8Bit());
        makeWindow([](Session& session) { loadTeapot(session); });
        m_session->settings().setFlightMode(FlightMode::Instant);
        connect(m_session.get(), &Session::undoChanged, this, [this] { say(); });
        connect(&m_session->hits(), &SessionHits::reset, this, [this] { say(); });
        auto* files = m_window->findChild<SessionFiles*>();
        files->save(QDir(folder).filePath(QStringLiteral("work.hitscope")));
        QTRY_VERIFY_WITH_TIMEOUT(!files->isBusy(), kPatience);
        say();
        std::mt19937 random(QRandomGenerator::global()->generate());
        const auto upTo = [&random](int most) { return static_cast<int>(random() % (most + 1u)); };
        for (;;) {
            act(upTo(9), upTo);
            say();
            QTest::qWait(upTo(60));
        }
    }

    template <class UpTo>
    void act(int action, const UpTo& upTo) {
        QWidget& viewport = m_window->viewport();
        const int hits = static_cast<int>(m_session->hits().history().size());
        switch (action) {
            default:
                QTest::mouseClick(
                    &viewport, Qt::LeftButton, {},
                    {viewport.width() / 4 + upTo(viewport.width() / 2), viewport.height() / 4 + upTo(200)});
                break;
            case 1:
                QTest::keyClick(&viewport, Qt::Key_Z, Qt::ControlModifier);
                break;
            case 2:
                QTest::keyClick(&viewport, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
                break;
            case 3:
                QTest::keyClick(&viewport, Qt::Key_S, Qt::ControlModifier);
                break;
            case 4:
                if (hits > 2) {
                    m_session->hits().remove(
                        std::vector<std::size_t>{static_cast<std::size_t>(upTo(hits - 1))});
                }
                break;
            case 5: {
                DeformationConstants constants = m_session->settings().constants();
                constants.power = 0.01f * static_cast<float>(1 + upTo(8));
                QVERIFY(m_session->settings().setConstants(constants).ok());
                break;
            }
            case 6:
                if (hits > 0) {
                    m_session->hits().setEnabled(
                        std::vector<std::size_t>{static_cast<std::size_t>(upTo(hits - 1))}, upTo(1) == 1);
                }
                break;
        }
    }

    void say() const {
        const State state = stateOf(captureSession(*m_session, {}));
        std::printf("state %.6f %s %s .\n", state.at, state.hits.constData(), state.others.constData());
        std::fflush(stdout);
    }
};

HITSCOPE_TEST(KilledTest, QApplication)

}  // namespace hitscope::killed_test

#include "killed_test.moc"
