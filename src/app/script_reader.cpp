// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/script_reader.h"

#include <QFileInfo>
#include <QTimer>
#include <optional>
#include <utility>

#include "analysis/beside.h"
#include "session/session.h"
#include "session/shots/shot_script_file.h"
#include "session/task_list.h"

namespace hitscope {

struct ScriptReader::Read {
    Then then;
    std::unique_ptr<TaskProgress> progress;  ///< null: it has not taken long so far
};

ScriptReader::ScriptReader(Session& session, QObject* parent, int worthShowing)
    : QObject(parent), m_session(session), m_worthShowing(worthShowing) {
    connect(&session, &Session::sceneReplaced, this, [this] { m_reads.clear(); });
}

ScriptReader::~ScriptReader() = default;

void ScriptReader::read(const QString& path, Then then) {
    const int number = ++m_last;
    m_reads[number] = std::make_unique<Read>(Read{std::move(then), {}});
    QTimer::singleShot(m_worthShowing, this, [this, number, path] { show(number, path); });
    const auto script = std::make_shared<std::optional<Result<ShotScript>>>();
    workBeside(
        this, [script, path] { *script = readShotScript(path); },
        [script, number, path](ScriptReader& self, bool done) {
            self.end(number, done ? **script
                                  : Error{"There is not enough memory for so many shots.", path.toStdString(),
                                          "Close other programs."});
        });
}

void ScriptReader::show(int number, const QString& path) {
    if (const auto read = m_reads.find(number); read != m_reads.end()) {
        read->second->progress = std::make_unique<TaskProgress>(
            m_session.tasks(), tr("Reading %1").arg(QFileInfo(path).fileName()),
            [this, number] { m_reads.erase(number); }, tr("Cancel; no shot of it is fired"));
    }
}

void ScriptReader::end(int number, const Result<ShotScript>& script) {
    const auto read = m_reads.find(number);
    if (read == m_reads.end()) {
        return;  // cancelled
    }
    const Then then = std::move(read->second->then);
    m_reads.erase(read);
    then(script);
}

}  // namespace hitscope
