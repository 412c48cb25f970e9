// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reload_bar.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "app/mesh_reloader.h"
#include "models/plain_text.h"
#include "session/shown_number.h"

namespace hitscope {

ReloadBar::ReloadBar(MeshReloader& reloader, QWidget* parent)
    : QFrame(parent), m_reloader(reloader), m_text(new QLabel(this)) {
    setObjectName(QStringLiteral("reload"));
    setFrameShape(QFrame::StyledPanel);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    auto* reload = new QPushButton(tr("Reload"), this);
    reload->setObjectName(QStringLiteral("reloadMeshes"));
    reload->setToolTip(tr("Read it again, and apply the hits to it; one step to undo"));
    auto* ignore = new QPushButton(tr("Ignore"), this);
    ignore->setObjectName(QStringLiteral("ignoreChange"));
    ignore->setToolTip(tr("Go on with the mesh as it was read"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->addWidget(m_text, 1);
    layout->addWidget(reload, 0, Qt::AlignTop);
    layout->addWidget(ignore, 0, Qt::AlignTop);
    connect(reload, &QPushButton::clicked, &reloader, &MeshReloader::reload);
    connect(ignore, &QPushButton::clicked, &reloader, &MeshReloader::ignore);
    connect(&reloader, &MeshReloader::changedFilesChanged, this, &ReloadBar::follow);
    hide();
}

void ReloadBar::follow() {
    constexpr qsizetype kMostNames = 3;
    const QStringList& files = m_reloader.changedFiles();
    QStringList names;
    QStringList paths;
    for (const QString& file : files) {
        names << QFileInfo(file).fileName();
        paths << QDir::toNativeSeparators(file);
    }
    const QString first = names.mid(0, kMostNames).join(QStringLiteral(", "));
    if (names.size() > kMostNames) {
        m_text->setText(tr("%1 and %Ln other {file|files} have changed on the disk.", nullptr,
                           static_cast<int>(names.size() - kMostNames))
                            .arg(first));
    } else if (names.size() > 1) {
        m_text->setText(tr("%1 have changed on the disk.").arg(first));
    } else {
        m_text->setText(tr("%1 has changed on the disk.").arg(first));
    }
    m_text->setToolTip(asPlainText(paths.join(u'\n')));
    setVisible(!files.isEmpty());
}

}  // namespace hitscope
