// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSettings>
#include <functional>
#include <memory>

namespace hitscope {

/// Settings to be changed. The file is written by another thread after this is gone, because the window would
/// wait for the disk. Every other QSettings of the program sees the changes at once; one that is made before
/// that thread has come to it writes them itself.
class ChangedSettings {
public:
    ChangedSettings();
    ~ChangedSettings();
    ChangedSettings(const ChangedSettings&) = delete;
    ChangedSettings& operator=(const ChangedSettings&) = delete;

    [[nodiscard]] QSettings& operator*() const { return *m_settings; }
    [[nodiscard]] QSettings* operator->() const { return m_settings.get(); }

    /// Hands the settings over; this has none afterwards. Call the result once, on another thread: it writes
    /// the file and returns whether it could.
    [[nodiscard]] std::function<bool()> writing();

private:
    std::unique_ptr<QSettings> m_settings;
};

}  // namespace hitscope
