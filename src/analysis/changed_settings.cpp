// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/changed_settings.h"

#include <utility>

#include "analysis/background_pool.h"

namespace hitscope {

ChangedSettings::ChangedSettings() : m_settings(std::make_unique<QSettings>()) {}

ChangedSettings::~ChangedSettings() {
    if (m_settings) {
        startInBackground([write = writing()] { write(); });
    }
}

std::function<bool()> ChangedSettings::writing() {
    m_settings->moveToThread(nullptr);  // it has asked for an event in which it would write
    // A std::function can be copied.
    auto held = std::make_shared<std::unique_ptr<QSettings>>(std::move(m_settings));
    return [held] {
        const std::unique_ptr<QSettings> settings = std::exchange(*held, nullptr);
        settings->sync();
        return settings->status() == QSettings::NoError && settings->isWritable();
    };
}

}  // namespace hitscope
