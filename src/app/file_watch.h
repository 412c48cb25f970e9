// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <map>
#include <string>
#include <vector>

#include "session/target_source.h"

namespace hitscope {

/// Tells when files get another content, whether they are written in place or another file takes their name.
/// What is only touched, or saved as it was, is not told. Files are read beside the window's work.
class FileWatch : public QObject {
    Q_OBJECT
public:
    static constexpr int kSettles = 300;  ///< milliseconds without an event until a file is read

    explicit FileWatch(QObject* parent = nullptr);

    /// The files from now on. One whose hash is not known counts as it is now; those that were among them
    /// before stay as they are known.
    void follow(const std::vector<MeshFile>& files);
    /// This program has just written it: what it holds now is no news.
    void expect(const QString& path);
    /// This program writes it from now on: nothing is read of it until release().
    void hold(const QString& path);
    /// No more, after as many calls as of hold(). isWritten: as expect().
    void release(const QString& path, bool isWritten);
    /// As it was read last; empty: it is not known.
    [[nodiscard]] std::string contentOf(const QString& path) const;

Q_SIGNALS:
    void changed(const QString& path);

private:
    /// Of a file on the disk; another one has most likely another content.
    struct Stamp {
        qint64 size = -1;  // -1: there is none
        qint64 time = 0;   // milliseconds
        bool operator==(const Stamp&) const = default;
    };
    struct Watched {
        std::string content;  // sha256; empty: not known yet
        Stamp stamp;
        bool isToRead = false;
        bool isExpected = false;  // what is read next
        bool isReading = false;
    };
    static Stamp stampOf(const QString& path);
    void note(const QString& path);
    void lookInto(const QString& folder);
    void readNoted();
    void read(const QString& path);
    void take(const QString& path, const std::string& content, const Stamp& stamp);
    void watch(const QString& path);

    QFileSystemWatcher m_watcher;
    QTimer m_settle;
    std::map<QString, Watched> m_files;
    QStringList m_held;  // canonical
};

}  // namespace hitscope
