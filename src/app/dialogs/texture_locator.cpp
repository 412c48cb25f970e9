// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dialogs/texture_locator.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "io/file_scope.h"
#include "io/read_picture.h"
#include "mesh/missing_textures.h"
#include "panels/help/help_text.h"
#include "session/session.h"

namespace hitscope {

namespace {

/// "wood.png" of "C:\textures\wood.png".
QString fileNameOf(const std::string& name) {
    QString path = fileNameText(name);
    return QFileInfo(path.replace(QLatin1Char('\\'), QLatin1Char('/'))).fileName();
}

}  // namespace

TextureLocator::TextureLocator(Session& session, QWidget* parent)
    : QObject(parent), m_session(session), m_parent(parent) {
    for (const auto signal : {&SessionTargets::added, &SessionTargets::removed, &SessionTargets::textured}) {
        connect(&session.targets(), signal, this, [this] { m_following.want(); });
    }
    connect(&session, &Session::sceneReplaced, this, [this] { m_following.now(); });
}

void TextureLocator::fill(QMenu& menu) {
    m_action = menu.addAction(tr("&Locate Missing Texture…"));
    connect(m_action, &QAction::triggered, this, &TextureLocator::locate);
    follow();
}

void TextureLocator::follow() {
    if (m_action != nullptr) {
        enableIf(*m_action, isAnyMissing(), tr("No texture is missing."));
    }
}

std::vector<TextureLocator::Missing> TextureLocator::missing() const {
    std::vector<const Target*> firsts;  // of each mesh
    std::unordered_map<const MeshData*, std::vector<TargetId>> ofMesh;
    for (const std::unique_ptr<Target>& target : m_session.targets()) {
        std::vector<TargetId>& same = ofMesh[target->shape.mesh.get()];
        if (same.empty()) {
            firsts.push_back(target.get());
        }
        same.push_back(target->id);
    }
    std::vector<Missing> found;
    for (const Target* target : firsts) {
        const MeshData* mesh = target->shape.mesh.get();
        for (const std::string& name : missingTextures(*mesh)) {
            found.push_back({ofMesh[mesh], target->sourcePath, name});
        }
    }
    return found;
}

bool TextureLocator::isAnyMissing() const {
    std::unordered_set<const MeshData*> seen;
    return std::any_of(m_session.targets().begin(), m_session.targets().end(),
                       [&seen](const std::unique_ptr<Target>& target) {
                           const MeshData* mesh = target->shape.mesh.get();
                           return seen.insert(mesh).second && !missingTextures(*mesh).empty();
                       });
}

void TextureLocator::locate() {
    const std::vector<Missing> all = missing();
    if (all.empty()) {
        return;
    }
    const QString folder = m_folder.isEmpty() ? QFileInfo(all.front().file).absolutePath() : m_folder;
    const QString path = QFileDialog::getOpenFileName(
        m_parent, tr("Locate Texture “%1”").arg(fileNameOf(all.front().name)), folder,
        tr("Pictures (*.png *.jpg *.jpeg *.bmp *.tga *.tif *.tiff *.webp *.gif);;All files (*)"));
    if (path.isEmpty()) {
        return;
    }
    if (const Status used = use(path); !used) {
        Q_EMIT failed(used.error());
    }
}

Status TextureLocator::use(const QString& path) {
    const std::vector<Missing> all = missing();
    if (all.empty()) {
        return Done{};
    }
    m_folder = QFileInfo(path).absolutePath();
    const QString name = QFileInfo(path).fileName();
    const auto same = std::find_if(all.begin(), all.end(), [&name](const Missing& what) {
        return fileNameOf(what.name).compare(name, Qt::CaseInsensitive) == 0;
    });
    if (Status used = use(same == all.end() ? all.front() : *same, path); !used) {
        return used;
    }
    // Where one is the others often are.
    for (const Missing& other : missing()) {
        const QString beside = QDir(m_folder).filePath(fileNameOf(other.name));
        if (QFileInfo(beside).isFile()) {
            static_cast<void>(use(other, beside));
        }
    }
    const std::size_t left = missing().size();
    Q_EMIT said(left == 0 ? tr("All textures are found.") : tr("Textures still missing: %1").arg(left));
    return Done{};
}

Status TextureLocator::use(const Missing& what, const QString& path) {
    Result<Image> image = readPicture(path);
    if (!image) {
        return image.error();
    }
    const Target* target = m_session.targets().find(what.targets.front());
    m_session.targets().setTexture(
        what.targets,
        std::make_shared<MeshData>(withTexture(*target->shape.mesh, what.name, std::move(image).value())),
        {what.name, QFileInfo(path).absoluteFilePath()});
    m_located[{what.file, what.name}] = path;
    return Done{};
}

QStringList TextureLocator::useRemembered() {
    QStringList used;
    for (const Missing& what : missing()) {
        const auto known = m_located.find({what.file, what.name});
        if (known != m_located.end()) {
            const QString path = known->second;
            if (use(what, path)) {
                used.append(QString::fromStdString(what.name));
            }
        }
    }
    return used;
}

}  // namespace hitscope
