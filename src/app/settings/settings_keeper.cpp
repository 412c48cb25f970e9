// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/settings_keeper.h"

#include <QCoreApplication>
#include <QEvent>
#include <QSettings>
#include <QWidget>
#include <memory>
#include <utility>

#include "analysis/beside.h"
#include "analysis/changed_settings.h"
#include "app/settings/app_settings.h"

namespace hitscope {

namespace {

constexpr int kSoon = 500;  // milliseconds

bool mayChangeSettings(const QObject& watched, QEvent::Type type) {
    if (type == QEvent::Move || type == QEvent::Resize) {
        const auto* widget = qobject_cast<const QWidget*>(&watched);
        return widget != nullptr && widget->isWindow();
    }
    return type == QEvent::MouseButtonRelease || type == QEvent::KeyRelease || type == QEvent::Wheel ||
           type == QEvent::Drop || type == QEvent::NonClientAreaMouseButtonRelease ||
           type == QEvent::WindowStateChange;
}

}  // namespace

SettingsKeeper::SettingsKeeper(std::function<void(QSettings&)> save, QObject* parent)
    : QObject(parent), m_save(std::move(save)) {
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoon);
    connect(&m_soon, &QTimer::timeout, this, &SettingsKeeper::saveBeside);
    QCoreApplication::instance()->installEventFilter(this);
    m_saved = values();
}

SettingsKeeper::~SettingsKeeper() = default;

void SettingsKeeper::lookSoon() {
    if (!m_soon.isActive()) {  // not put off by one change after another
        m_soon.start();
    }
}

bool SettingsKeeper::eventFilter(QObject* watched, QEvent* event) {
    if (mayChangeSettings(*watched, event->type())) {
        lookSoon();
    }
    return QObject::eventFilter(watched, event);
}

/// Gathered in settings that are emptied before they would be written. What is not put into them stays as it
/// was saved.
QMap<QString, QVariant> SettingsKeeper::values() const {
    QSettings scratch(QStringLiteral("/dev/null/settings"), QSettings::IniFormat);  // nothing can be there
    for (auto saved = m_saved.begin(); saved != m_saved.end(); ++saved) {
        scratch.setValue(saved.key(), saved.value());
    }
    m_save(scratch);
    QMap<QString, QVariant> values;
    for (const QString& key : scratch.allKeys()) {
        values.insert(key, scratch.value(key));
    }
    scratch.clear();
    return values;
}

void SettingsKeeper::writeChanges(QSettings& settings, const QMap<QString, QVariant>& now) const {
    const QString recent = QLatin1String(kRecentFilesKey);
    for (auto value = now.begin(); value != now.end(); ++value) {
        const QVariant before = m_saved.value(value.key());
        if (value.value() == before) {
            continue;
        }
        settings.setValue(value.key(),
                          value.key() != recent
                              ? value.value()
                              : mergedRecentFiles(value.value().toStringList(), before.toStringList(),
                                                  settings.value(recent).toStringList()));
    }
    for (auto saved = m_saved.begin(); saved != m_saved.end(); ++saved) {
        if (!now.contains(saved.key())) {
            settings.remove(saved.key());
        }
    }
}

void SettingsKeeper::saveNow() {
    m_soon.stop();
    QMap<QString, QVariant> now = values();
    if (now == m_saved) {
        return;
    }
    QSettings settings;
    writeChanges(settings, now);
    settings.sync();
    noteSaved(std::move(now), settings.status() == QSettings::NoError && settings.isWritable(),
              settings.fileName());
}

void SettingsKeeper::saveBeside() {
    if (m_isSaving) {
        lookSoon();
        return;
    }
    QMap<QString, QVariant> now = values();
    if (now == m_saved) {
        return;
    }
    m_isSaving = true;
    ChangedSettings settings;
    writeChanges(*settings, now);
    const QString file = settings->fileName();
    auto isSaved = std::make_shared<bool>(false);
    workBeside(
        this, [write = settings.writing(), isSaved] { *isSaved = write(); },
        [now = std::move(now), isSaved, file](SettingsKeeper& keeper, bool /*done*/) {
            keeper.m_isSaving = false;
            keeper.noteSaved(now, *isSaved, file);
        });
}

void SettingsKeeper::noteSaved(QMap<QString, QVariant> values, bool isSaved, const QString& file) {
    if (isSaved) {
        m_saved = std::move(values);
    } else if (!std::exchange(m_hasFailed, true)) {
        Q_EMIT failed(file);
    }
}

}  // namespace hitscope
