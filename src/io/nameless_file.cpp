// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/nameless_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <cerrno>
#include <cstdlib>

namespace hitscope {

NamelessFile::NamelessFile() {
    const QByteArray folder = QFile::encodeName(QDir::tempPath());
    m_descriptor = ::open(folder.constData(), O_TMPFILE | O_RDWR | O_EXCL | O_CLOEXEC, 0600);
    if (m_descriptor < 0) {  // some file systems have no such files
        QByteArray name = folder + "/hitscope-XXXXXX";
        m_descriptor = ::mkostemp(name.data(), O_CLOEXEC);
        if (m_descriptor >= 0) {
            ::unlink(name.constData());
        } else {
            m_whyNot = qt_error_string(errno);
        }
    }
}

NamelessFile::~NamelessFile() {
    close();
}

QString NamelessFile::path() const {
    return QStringLiteral("/proc/%1/fd/%2").arg(::getpid()).arg(m_descriptor);
}

std::uint64_t NamelessFile::size() const {
    struct stat info {};
    return ::fstat(m_descriptor, &info) == 0 ? static_cast<std::uint64_t>(info.st_size) : 0;
}

void NamelessFile::close() {
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
        m_descriptor = -1;
    }
}

}  // namespace hitscope
