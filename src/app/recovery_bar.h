// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <memory>

#include "core/result.h"

class QLabel;

namespace hitscope {

class DiscardGuard;
class SessionFiles;

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

Q_SIGNALS:
    void failed(const hitscope::Error& error);

private:
    struct Found;

    void take(const std::shared_ptr<Found>& found);
    [[nodiscard]] static QString fileOf(const Found& found);
    void recover();
    void askToDiscard();
    void discard();

    SessionFiles& m_files;
    DiscardGuard& m_guard;
    QString m_folder;
    QLabel* m_text = nullptr;
    QLabel* m_picture = nullptr;     ///< hidden where the journal has none
    std::shared_ptr<Found> m_found;  ///< null: nothing is offered
    bool m_isReading = false;
    QStringList m_passedOver;  ///< journals that cannot be read
};

}  // namespace hitscope
