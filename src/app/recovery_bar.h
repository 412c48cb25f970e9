// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <memory>
#include <vector>

#include "app/session_files.h"
#include "core/result.h"

class QLabel;

namespace hitscope {

class DiscardGuard;

/// A bar that offers what a window left behind that did not end in order: to go on with it, or to discard it
/// for good. Hidden where there is none. Several are offered one after the other, newest first.
class RecoveryBar : public QFrame {
    Q_OBJECT
public:
    /// Journals are in `folder`. `files` and `guard` outlive this.
    RecoveryBar(SessionFiles& files, DiscardGuard& guard, const QString& folder, QWidget* parent = nullptr);
    ~RecoveryBar() override;

    /// Looks for one, and reads it beside the window's work.
    void look();
    /// What was recovered is safe elsewhere: the journals that it was recovered from go.
    void dropRecovered();

Q_SIGNALS:
    void failed(const hitscope::Error& error);
    void noticeWanted(const QString& text);

private:
    struct Found;

    void take(const std::shared_ptr<Found>& found);
    [[nodiscard]] static QString fileOf(const Found& found);
    [[nodiscard]] QString othersText() const;
    void postpone();
    void recover();
    void askToDiscard();
    void takeEnded(const std::shared_ptr<Found>& found, SessionFiles::Ended how);
    void discard();

    SessionFiles& m_files;
    DiscardGuard& m_guard;
    QString m_folder;
    QLabel* m_text = nullptr;
    QLabel* m_picture = nullptr;                      ///< hidden where the journal has none
    std::shared_ptr<Found> m_found;                   ///< null: nothing is offered
    std::vector<std::shared_ptr<Found>> m_recovered;  ///< that dropRecovered() is awaited for
    bool m_isReading = false;
    QStringList m_passedOver;  ///< journals that cannot be read, or are left for later
};

}  // namespace hitscope
