// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <memory>

#include "core/result.h"
#include "session/shots/shot_script.h"

namespace hitscope {

class Session;

/// Reads shot scripts on another thread: one may have 64 MiB. What takes longer than a moment is listed among
/// the session's tasks, where it can be cancelled. With the scene go the scripts that were meant for it.
class ScriptReader : public QObject {
    Q_OBJECT
public:
    static constexpr int kWorthShowing = 500;  ///< milliseconds

    /// `session` outlives this. `worthShowing`: milliseconds, for tests.
    explicit ScriptReader(Session& session, QObject* parent = nullptr, int worthShowing = kWorthShowing);
    ~ScriptReader() override;

    using Then = std::function<void(const Result<ShotScript>& script)>;
    /// then() follows, unless it is cancelled.
    void read(const QString& path, Then then);
    [[nodiscard]] bool isReading() const { return !m_reads.empty(); }

private:
    struct Read;
    void show(int number, const QString& path);
    void end(int number, const Result<ShotScript>& script);

    Session& m_session;
    int m_worthShowing;
    int m_last = 0;  ///< number given
    std::map<int, std::unique_ptr<Read>> m_reads;
};

}  // namespace hitscope
