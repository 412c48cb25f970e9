// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "session/session.h"

class QMessageBox;
class QWidget;

namespace hitscope {

class SessionFiles;

/// Asks before work is lost. Whatever replaces the session or ends the program passes through here. A session
/// is at risk when it was changed since it was saved; one that is in no file, when it has hits that were not
/// exported: with their target as it is with them, or all together.
class DiscardGuard : public QObject {
    Q_OBJECT
public:
    /// Begins to save the session; false: the person decided otherwise.
    using BeginSave = std::function<bool()>;

    /// `session` and `files` outlive this; the question belongs to `window`.
    DiscardGuard(Session& session, SessionFiles& files, QWidget& window, BeginSave beginSave);

    [[nodiscard]] bool isAtRisk() const;

    /// Calls `then` at once if nothing would be lost; else when the person has discarded the changes, or
    /// saved them, which is done first; `instead` when they keep the session as it is. Returns at once.
    void ask(std::function<void()> then, std::function<void()> instead = {});
    /// The same, waiting for the answer; true: go on.
    [[nodiscard]] bool askAndWait();
    /// What there is now is given up: no more questions about it.
    void letGo();

    /// The desktop's session ends. `manager`: a QSessionManager, or what has its functions.
    template <class Manager>
    void answer(Manager& manager) {
        if (!isAtRisk() || !manager.allowsInteraction()) {
            return;
        }
        if (askAndWait()) {
            letGo();
            manager.release();
        } else {
            manager.cancel();
        }
    }

    /// To be told of every export of targets as they are shown now, and of its end. Those to one file end in
    /// the order that they began in.
    void exportBegins(const std::vector<const Target*>& targets, const QString& path);
    void exportEnds(const QString& path, bool isWritten);
    /// The same for files of all hits.
    void hitsExportBegins() { m_writingHits = stateOfAll(); }
    void hitsExported() { m_keptHits = m_writingHits; }

Q_SIGNALS:
    void saveEnded();  ///< one that a question was answered with

private:
    using State = std::uint64_t;  ///< tells apart what hits do to a target
    /// As it was exported.
    struct Exported {
        State hits = 0;
        std::uint64_t work = 0;  ///< workOnTargets() then
        QString path;
    };
    struct Writing {
        QString path;
        std::map<TargetId, Exported> targets;
    };

    [[nodiscard]] std::map<TargetId, State> states(std::span<const Hit> hits) const;
    [[nodiscard]] std::vector<TargetId> targetsAtRisk() const;
    [[nodiscard]] State stateOfAll() const;
    [[nodiscard]] std::size_t hitsAtRisk() const;
    /// They were added, moved or changed, and not all of them were exported.
    [[nodiscard]] bool areTargetsAtRisk() const;
    QMessageBox* makeBox();
    void take(QMessageBox& box, const std::function<void()>& then, const std::function<void()>& instead);
    void beginSave();
    void takeSaved(bool isSaved);

    Session& m_session;
    SessionFiles& m_files;
    QWidget& m_window;
    BeginSave m_beginSave;
    std::map<TargetId, Exported> m_exported;
    std::vector<Writing> m_writing;   ///< in the order that they began in
    std::function<void()> m_then;     ///< after the save that is under way; empty: none is awaited
    std::function<void()> m_instead;  ///< where that is not saved
    std::optional<State> m_keptHits;  ///< of all hits: no question about these
    std::optional<State> m_writingHits;
    QPointer<QMessageBox> m_box;
};

}  // namespace hitscope
