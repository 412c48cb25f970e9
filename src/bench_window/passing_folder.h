// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTemporaryDir>

namespace hitscope::bench {

/// A folder below the system's for temporary files. It goes with this; after leaveNothingBehind() also when
/// the program is ended.
class PassingFolder {
public:
    PassingFolder();
    ~PassingFolder();
    PassingFolder(const PassingFolder&) = delete;
    PassingFolder& operator=(const PassingFolder&) = delete;

    [[nodiscard]] bool isValid() const { return m_folder.isValid(); }
    [[nodiscard]] QString path() const { return m_folder.path(); }
    [[nodiscard]] QString filePath(const QString& name) const { return m_folder.filePath(name); }

private:
    QTemporaryDir m_folder;
};

/// From now on such folders and half-written files are removed when SIGTERM, SIGINT or SIGHUP ends the
/// program, and when Qt does because the display has gone. Once, in main().
void leaveNothingBehind();

}  // namespace hitscope::bench
