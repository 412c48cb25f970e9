// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QObject>
#include <QTimer>
#include <QVariant>
#include <functional>

class QSettings;

namespace hitscope {

/// Saves the settings half a second after the person has done something that changed them, so that a crash
/// takes none along. Only what has changed here is written: the rest may be another window's by now.
class SettingsKeeper : public QObject {
    Q_OBJECT
public:
    /// `save` puts all settings into what it is given, as they are now, which counts as saved.
    explicit SettingsKeeper(std::function<void(QSettings&)> save, QObject* parent = nullptr);
    ~SettingsKeeper() override;

    /// Looks for changes soon; input events come to that by themselves.
    void lookSoon();
    /// Before the program ends: it waits for the disk.
    void saveNow();

Q_SIGNALS:
    /// Once: they cannot be saved. `file` is where they would be.
    void failed(const QString& file);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void saveBeside();
    void writeChanges(QSettings& settings, const QMap<QString, QVariant>& now) const;
    void noteSaved(QMap<QString, QVariant> values, bool isSaved, const QString& file);
    [[nodiscard]] QMap<QString, QVariant> values() const;

    std::function<void(QSettings&)> m_save;
    QTimer m_soon;
    QMap<QString, QVariant> m_saved;  ///< by this window, or as it began
    bool m_isSaving = false;          ///< by another thread
    bool m_hasFailed = false;
};

}  // namespace hitscope
