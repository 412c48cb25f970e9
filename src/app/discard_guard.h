// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "session/session.h"

class QMessageBox;
class QWidget;

namespace hitscope {

/// Asks before hits are discarded. Whatever replaces the scene or ends the program passes through here. Hits
/// count as kept once their target is exported as it is with them, or all hits are.
class DiscardGuard : public QObject {
    Q_OBJECT
public:
    /// Begins to export the targets and gives the paths; none: the person decided otherwise.
    using BeginExport = std::function<QStringList(const std::vector<TargetId>& targets)>;

    /// `session` outlives this; the question belongs to `window`.
    DiscardGuard(Session& session, QWidget& window, BeginExport beginExport);

    /// Hits that would be lost.
    [[nodiscard]] std::size_t hitsAtRisk() const;
    [[nodiscard]] bool isAtRisk() const { return hitsAtRisk() > 0; }

    /// Calls `then` at once if nothing would be lost; else when the person has discarded the hits, or
    /// exported them, which is done first. Returns at once.
    void ask(std::function<void()> then);
    /// The same, waiting for the answer; true: go on.
    [[nodiscard]] bool askAndWait();
    /// These hits are given up: no more questions about them.
    void letGo() { m_letGo = stateOfAll(); }

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

    /// To be told of every export of a target as it is shown now, and of its end.
    void exportBegins(const Target& target, const QString& path);
    void exportEnds(const QString& path, bool isWritten);
    /// The same for files of all hits.
    void hitsExportBegins() { m_writingHits = stateOfAll(); }
    void hitsExported() { m_letGo = m_writingHits; }

Q_SIGNALS:
    void exportsEnded();  ///< those that a question was answered with

private:
    using State = std::uint64_t;  ///< tells apart what hits do to a target
    struct Writing {
        TargetId target;
        State state = 0;
    };

    [[nodiscard]] std::map<TargetId, State> states(std::span<const Hit> hits) const;
    [[nodiscard]] std::vector<TargetId> targetsAtRisk() const;
    [[nodiscard]] State stateOfAll() const;
    QMessageBox* makeBox();
    void take(QMessageBox& box, const std::function<void()>& then);
    void exportAnd(const std::function<void()>& then);

    Session& m_session;
    QWidget& m_window;
    BeginExport m_beginExport;
    std::map<TargetId, State> m_exported;
    std::map<QString, Writing> m_writing;
    std::set<QString> m_awaited;  ///< exports after which m_then is to be called
    std::function<void()> m_then;
    std::optional<State> m_letGo;  ///< of all hits: no question about these
    std::optional<State> m_writingHits;
    QPointer<QMessageBox> m_box;
};

}  // namespace hitscope
