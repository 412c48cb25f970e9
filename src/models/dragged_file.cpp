// SPDX-License-Identifier: GPL-3.0-or-later
#include "models/dragged_file.h"

#include <QDir>
#include <QTemporaryDir>
#include <QUrl>
#include <utility>

namespace hitscope {

namespace {

const QString kFiles = QStringLiteral("text/uri-list");
const QString kText = QStringLiteral("text/plain");

/// A folder for one file, so that it can have its name; empty: there is no room.
QString newFolder() {
    static const QTemporaryDir all;
    static int made = 0;
    const QString folder = all.filePath(QString::number(++made));
    return all.isValid() && QDir().mkpath(folder) ? folder : QString();
}

}  // namespace

DraggedFile::DraggedFile(QString name, Write write, std::function<QString()> text)
    : m_name(std::move(name)), m_write(std::move(write)), m_text(std::move(text)) {}

QStringList DraggedFile::formats() const {
    QStringList own{kFiles};
    if (m_text) {
        own += kText;
    }
    return QMimeData::formats() + own;
}

bool DraggedFile::hasFormat(const QString& type) const {
    return type == kFiles || (m_text && type == kText) || QMimeData::hasFormat(type);
}

QVariant DraggedFile::retrieveData(const QString& type, QMetaType preferred) const {
    if (m_text && type == kText) {
        return m_text();
    }
    if (type != kFiles) {
        return QMimeData::retrieveData(type, preferred);
    }
    if (m_path.isEmpty()) {
        const QString folder = newFolder();
        const QString path = folder + u'/' + m_name;
        if (folder.isEmpty() || !m_write(path)) {
            return {};
        }
        m_path = path;
    }
    return QVariantList{QUrl::fromLocalFile(m_path)};
}

}  // namespace hitscope
