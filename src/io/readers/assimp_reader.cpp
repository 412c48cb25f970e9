// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/readers/assimp_reader.h"

#include <assimp/scene.h>

#include <assimp/BaseImporter.h>
#include <assimp/importerdesc.h>

#include <QFileInfo>
#include <QRegularExpression>
#include <algorithm>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <new>
#include <sstream>

#include "io/readers/assimp_check.h"
#include "io/readers/assimp_files.h"
#include "io/readers/assimp_materials.h"
#include "io/readers/dae_check.h"
#include "io/readers/fbx_check.h"
#include "io/readers/gltf_numbers.h"
#include "io/readers/gltf_prepare.h"
#include "io/readers/scene_merger.h"
#include "io/readers/tidy.h"

namespace hitscope {
namespace {

class Progress : public Assimp::ProgressHandler {
public:
    explicit Progress(const ProgressSink& sink) : m_sink(sink) {}
    bool Update(float fraction) override {
        if (m_sink) {
            m_sink(fraction >= 0.0f && fraction <= 1.0f ? static_cast<double>(fraction) : 0.0, "Reading");
        }
        return true;
    }

private:
    const ProgressSink& m_sink;
};

void noteWhatIsLeftOut(const aiScene& scene, bool hasMorphed, ImportedMesh& imported) {
    bool hasBones = false;
    bool hasMorphs = false;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        hasBones = hasBones || scene.mMeshes[m]->HasBones();
        hasMorphs = hasMorphs || scene.mMeshes[m]->mNumAnimMeshes > 0;
    }
    if (hasMorphed) {
        imported.notes += QStringLiteral("Morph targets were applied with the weights that the file gives.");
    }
    if (hasBones || scene.HasAnimations() || (hasMorphs && !hasMorphed)) {
        imported.notes += hasMorphed ? QStringLiteral("Animations and bones were left out.")
                                     : QStringLiteral("Animations, bones and morph targets were left out.");
    }
}

/// Assimp makes metres, and y up, of what two formats say.
void noteConversion(const std::string& suffix, std::string_view content, ImportedMesh& imported) {
    if (suffix == "3ds") {
        imported.notes += QStringLiteral("z points up in the file: the mesh was turned, so that y does.");
    }
    if (suffix != "dae") {
        return;
    }
    constexpr std::size_t kHead = 65'536;  // bytes: the asset comes first
    const auto length = static_cast<qsizetype>(std::min(content.size(), kHead));
    const QString head = QString::fromUtf8(content.data(), length);
    static const QRegularExpression unit(QStringLiteral("<unit\\b[^>]*\\bmeter\\s*=\\s*[\"']([^\"']*)[\"']"));
    static const QRegularExpression up(QStringLiteral("<up_axis>\\s*([XZ])_UP\\s*<"));
    bool isNumber = false;
    const double metres = unit.match(head).captured(1).trimmed().toDouble(&isNumber);
    if (isNumber && metres > 0.0 && metres != 1.0) {
        imported.notes +=
            QStringLiteral("The file's unit is %1 m: its coordinates were converted to metres.").arg(metres);
    }
    if (const QString axis = up.match(head).captured(1).toLower(); !axis.isEmpty()) {
        imported.notes +=
            QStringLiteral("%1 points up in the file: the mesh was turned, so that y does.").arg(axis);
    }
}

/// Assimp tries all its readers, of some fifty formats, on a file that the one for its suffix does not want.
void keepReadersOf(const std::string& suffix, Assimp::Importer& importer) {
    for (std::size_t i = importer.GetImporterCount(); i > 0; --i) {
        std::istringstream suffixes(importer.GetImporterInfo(i - 1)->mFileExtensions);
        bool reads = false;
        for (std::string each; suffixes >> each;) {
            reads = reads || each == suffix;
        }
        if (!reads) {
            Assimp::BaseImporter* const reader = importer.GetImporter(i - 1);
            importer.UnregisterLoader(reader);
            delete reader;
        }
    }
}

/// `why`: with a full stop or without; `advice`: empty if there is none better than the usual.
Error unreadable(const std::string& suffix, std::string why, const std::string& where,
                 const std::string& advice = {}) {
    while (why.ends_with('.')) {
        why.pop_back();
    }
    return {
        "It cannot be read as " + QString::fromStdString(suffix).toUpper().toStdString() + ": " + why + ".",
        where,
        advice.empty()
            ? "It may be damaged, or its suffix be wrong. Try opening and saving it with another program."
            : advice};
}

bool isGltf(const std::string& suffix) {
    return suffix == "gltf" || suffix == "glb";
}

/// Of a glTF file also what is to be read instead of it, and how many triangles it promises: Assimp leaves
/// out, and says nothing, those whose corners there are not.
Result<PreparedGltf> prepare(const std::string& suffix, std::string_view content, const QString& folder) {
    if (isGltf(suffix)) {
        Result<PreparedGltf> prepared = prepareGltf(content, folder);
        const Error bad = prepared ? Error{} : prepared.error();
        return prepared ? std::move(prepared) : unreadable(suffix, bad.what, bad.where, bad.advice);
    }
    if (suffix == "dae" || suffix == "fbx") {
        const Status checked = suffix == "dae" ? checkDae(content) : checkFbx(content);
        if (!checked) {
            return unreadable(suffix, checked.error().what, checked.error().where);
        }
    }
    return PreparedGltf{};
}

Status checkAfter(const aiScene& scene, std::uint64_t promised) {
    if (Status checked = checkScene(scene); !checked) {
        return checked;
    }
    std::uint64_t triangles = 0;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[m];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            triangles += mesh.mFaces[f].mNumIndices == 3 ? 1 : 0;
        }
    }
    if (triangles < promised) {
        return Error{std::to_string(promised - triangles) + " of its " + std::to_string(promised) +
                         " triangles refer to vertices that it does not have.",
                     {},
                     "Write the file again with the program it came from."};
    }
    return Done{};
}

}  // namespace

Result<ImportedMesh> readWithAssimp(const QString& path, std::string_view content,
                                    const ProgressSink& progress) {
    const QFileInfo info(path);
    const std::string suffix = info.suffix().toLower().toStdString();
    constexpr std::string_view kBinaryOfVersion1("glTF\1", 5);
    if (isGltf(suffix) && content.starts_with(kBinaryOfVersion1)) {  // Assimp takes its lengths for others
        return Error{"It is binary glTF 1.0, which cannot be read.",
                     {},
                     "Save it as glTF 2.0 with the program it came from."};
    }
    Result<PreparedGltf> prepared = prepare(suffix, content, info.absolutePath());
    if (!prepared) {
        return prepared.error();
    }
    const PreparedGltf& gltf = prepared.value();
    Assimp::Importer importer;
    keepReadersOf(suffix, importer);
    importer.SetIOHandler(  // which the importer deletes
        makeFolderFiles(info.absoluteFilePath(), {.namesAreUris = isGltf(suffix),
                                                  .document = gltf.document,
                                                  .otherName = kDecodedGltfBuffer,
                                                  .other = gltf.numbers})
            .release());
    importer.SetProgressHandler(new Progress(progress));
    const aiScene* const scene = importer.ReadFile(info.absoluteFilePath().toUtf8().constData(), 0);
    if (!scene || !scene->mRootNode) {
        const std::string why = importer.GetErrorString();
        if (why.find("bad_alloc") != std::string::npos) {
            throw std::bad_alloc();
        }
        return unreadable(suffix, why, {});
    }
    if (const Status checked = checkAfter(*scene, gltf.triangles); !checked) {
        return checked.error();
    }
    ImportedMesh imported;
    SceneMerger merger(
        *scene, imported,
        {.weld = suffix == "fbx" || suffix == "3ds" || suffix == "dae", .morph = isGltf(suffix)});
    if (const Status merged = merger.merge(); !merged) {
        return merged.error();
    }
    if (isGltf(suffix)) {
        turnColoursToSrgb(imported.mesh);
    }
    convertMaterials(*scene, imported);
    if (isGltf(suffix)) {
        nameTexturesOfUris(info.absolutePath(), imported.mesh);
    }
    imported.notes += gltf.notes;
    noteConversion(suffix, content, imported);
    noteWhatIsLeftOut(*scene, merger.hasMorphed(), imported);
    tidy(imported);
    return imported;
}

}  // namespace hitscope
