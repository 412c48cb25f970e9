// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/file_watch.h"

#include <QDateTime>
#include <QFileInfo>
#include <QSet>
#include <memory>
#include <utility>

#include "analysis/beside.h"
#include "session/target_plan.h"

namespace hitscope {

FileWatch::FileWatch(QObject* parent) : QObject(parent) {
    m_settle.setSingleShot(true);
    m_settle.setInterval(kSettles);
    connect(&m_settle, &QTimer::timeout, this, &FileWatch::readNoted);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, &FileWatch::note);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &FileWatch::lookInto);
}

FileWatch::Stamp FileWatch::stampOf(const QString& path) {
    const QFileInfo info(path);
    return info.isFile() ? Stamp{info.size(), info.lastModified().toMSecsSinceEpoch()} : Stamp{};
}

void FileWatch::follow(const std::vector<MeshFile>& files) {
    std::map<QString, Watched> before = std::exchange(m_files, {});
    QSet<QString> wanted;
    for (const MeshFile& file : files) {
        const auto known = before.find(file.path);
        Watched& watched = m_files[file.path];
        wanted << file.path << QFileInfo(file.path).absolutePath();
        if (known != before.end()) {
            watched = known->second;
            continue;
        }
        watch(file.path);
        watched.content = file.sha256;
        watched.stamp = stampOf(file.path);
        if (file.sha256.empty() || watched.stamp.size != static_cast<qint64>(file.size)) {
            note(file.path);
        }
    }
    QStringList gone = m_watcher.files() + m_watcher.directories();
    gone.removeIf([&wanted](const QString& path) { return wanted.contains(path); });
    if (!gone.isEmpty()) {
        m_watcher.removePaths(gone);
    }
}

void FileWatch::hold(const QString& path) {
    m_held << QFileInfo(path).canonicalFilePath();
}

void FileWatch::release(const QString& path, bool isWritten) {
    // A file that was not there when it was held had no such path.
    if (!m_held.removeOne(QFileInfo(path).canonicalFilePath())) {
        m_held.removeOne(QString());
    }
    if (isWritten) {
        expect(path);
    }
    m_settle.start();
}

void FileWatch::expect(const QString& path) {
    const QString written = QFileInfo(path).canonicalFilePath();
    for (auto& [watchedPath, watched] : m_files) {
        if (QFileInfo(watchedPath).canonicalFilePath() == written) {
            watched.isExpected = true;
            note(watchedPath);
        }
    }
}

std::string FileWatch::contentOf(const QString& path) const {
    const auto known = m_files.find(path);
    return known != m_files.end() ? known->second.content : std::string();
}

/// Its folder tells when another file takes its name: then nothing more is told of the file itself.
void FileWatch::watch(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    if (!m_watcher.directories().contains(folder)) {
        m_watcher.addPath(folder);
    }
    if (QFileInfo::exists(path) && !m_watcher.files().contains(path)) {
        m_watcher.addPath(path);
    }
}

void FileWatch::note(const QString& path) {
    if (const auto known = m_files.find(path); known != m_files.end()) {
        known->second.isToRead = true;
        m_settle.start();
    }
}

void FileWatch::lookInto(const QString& folder) {
    for (const auto& [path, watched] : m_files) {
        if (QFileInfo(path).absolutePath() == folder && stampOf(path) != watched.stamp) {
            note(path);
        }
    }
}

void FileWatch::readNoted() {
    for (auto& [path, watched] : m_files) {
        if (watched.isToRead && !watched.isReading && !m_held.contains(QFileInfo(path).canonicalFilePath())) {
            watched.isToRead = false;
            watch(path);
            watched.stamp = stampOf(path);
            if (watched.stamp.size >= 0) {
                watched.isReading = true;
                read(path);
            }
        }
    }
}

void FileWatch::read(const QString& path) {
    auto now = std::make_shared<MeshFile>();
    const Stamp stamp = m_files[path].stamp;
    workBeside(
        this, [now, path] { *now = meshFileAt(path); },
        [now, path, stamp](FileWatch& self, bool) { self.take(path, now->sha256, stamp); });
}

void FileWatch::take(const QString& path, const std::string& content, const Stamp& stamp) {
    const auto known = m_files.find(path);
    if (known == m_files.end()) {
        return;
    }
    Watched& watched = known->second;
    watched.isReading = false;
    if (watched.isToRead || stampOf(path) != stamp) {
        note(path);  // it was still being written
    } else if (!content.empty()) {
        const std::string before = std::exchange(watched.content, content);
        const bool isNews = !std::exchange(watched.isExpected, false);
        if (isNews && !before.empty() && before != content) {
            Q_EMIT changed(path);
        }
    }
}

}  // namespace hitscope
