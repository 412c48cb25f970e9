// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/display_actions.h"

#include <QActionGroup>
#include <QMenu>

#include "app/actions/menu_building.h"
#include "app/actions/shading_actions.h"
#include "app/dialogs/texture_chooser.h"
#include "panels/icons/themed_icon.h"
#include "viewport/viewport.h"

namespace hitscope {

DisplayActions::DisplayActions(Viewport& viewport, TextureChooser& textures, QObject* parent)
    : QObject(parent), m_viewport(viewport), m_textureChooser(textures) {}

void DisplayActions::fill(QMenu& menu, const std::function<void(QMenu&)>& fillMiddle) {
    m_wireframeMenu = menu.addMenu(tr("&Wireframe"));
    makeWireframeMenu(*m_wireframeMenu);
    m_shading = new ShadingActions(this);
    m_shading->fill(*menu.addMenu(tr("S&hading")));
    connect(m_shading, &ShadingActions::switched, this, [this](DisplayOption option, bool on) {
        change([option, on](DisplayOptions& display) { display.*option = on; });
    });
    connect(&m_viewport.pictures().refiner(), &PictureRefiner::failed, m_shading, [this] {
        m_shading->disable(&DisplayOptions::refine, m_viewport.pictures().refiner().whyNot());
    });
    makeMaterialMenu(*menu.addMenu(tr("&Material")));
    makeNormalsMenu(*menu.addMenu(tr("&Normals")));
    QMenu& textures = *menu.addMenu(tr("Te&xture"));
    m_textureChooser.fill(textures);
    textures.addSeparator();
    m_textures = addToggle(textures, tr("&Show Textures"), Qt::Key_T, true, this, [this](bool on) {
        change([on](DisplayOptions& display) { display.textures = on; });
    });
    fillMiddle(menu);
    m_floor = addToggle(menu, tr("F&loor"), {}, true, this,
                        [this](bool on) { change([on](DisplayOptions& display) { display.floor = on; }); });
    m_crosshair = addToggle(menu, tr("Cro&sshair"), Qt::Key_C, false, this, [this](bool on) {
        change([on](DisplayOptions& display) { display.crosshair = on; });
    });
    follow();
}

void DisplayActions::fillEnd(QMenu& menu) {
    m_continuous = addToggle(menu, tr("Draw C&ontinuously"), {}, false, this,
                             [this](bool on) { m_viewport.setDrawsContinuously(on); });
    m_continuous->setIcon(themedIcon(QStringLiteral("continuous")));
    m_continuous->setIconVisibleInMenu(false);  // it would hide the check mark
    m_continuous->setToolTip(tr("Draw frames even when nothing changes, to measure the frame rate"));
}

void DisplayActions::makeWireframeMenu(QMenu& menu) {
    auto* group = new QActionGroup(this);
    const std::array<QString, 3> names{tr("&Off"), tr("O&ver the Surface"), tr("O&nly")};
    for (std::size_t mode = 0; mode < names.size(); ++mode) {
        m_wireframes[mode] = addChoice(menu, *group, names[mode], false, this, [this, mode] {
            change([mode](DisplayOptions& display) { display.wireframe = static_cast<WireframeMode>(mode); });
        });
    }
    menu.addSeparator();
    addAction(menu, tr("Next &Mode"), Qt::Key_L, this, [this] { cycleWireframe(); });
}

void DisplayActions::makeMaterialMenu(QMenu& menu) {
    auto* group = new QActionGroup(this);
    const std::array<QString, kSurfaceLooks> names{tr("&As in the File"), tr("&Matcap"), tr("&Clay"),
                                                   tr("M&etal")};
    for (std::size_t look = 0; look < names.size(); ++look) {
        m_looks[look] = addChoice(menu, *group, names[look], false, this, [this, look] {
            change([look](DisplayOptions& display) { display.look = static_cast<SurfaceLook>(look); });
        });
    }
}

void DisplayActions::makeNormalsMenu(QMenu& menu) {
    auto* group = new QActionGroup(this);
    const std::array<QString, 2> names{tr("&True (of the Dented Surface)"), tr("&Paper (Equation 2)")};
    for (std::size_t mode = 0; mode < names.size(); ++mode) {
        m_normals[mode] = addChoice(menu, *group, names[mode], false, this, [this, mode] {
            change([mode](DisplayOptions& display) { display.normals = static_cast<NormalMode>(mode); });
        });
    }
    menu.addSeparator();
    addAction(menu, tr("&Switch"), Qt::Key_N, this, [this] {
        change([](DisplayOptions& display) {
            display.normals = display.normals == NormalMode::True ? NormalMode::Paper : NormalMode::True;
        });
    });
}

void DisplayActions::follow() {
    if (m_crosshair == nullptr) {
        return;
    }
    const DisplayOptions& display = m_viewport.options();
    m_wireframes[static_cast<std::size_t>(display.wireframe)]->setChecked(true);
    m_normals[static_cast<std::size_t>(display.normals)]->setChecked(true);
    m_looks[static_cast<std::size_t>(display.look)]->setChecked(true);
    m_textures->setChecked(display.textures);
    m_floor->setChecked(display.floor);
    m_crosshair->setChecked(display.crosshair);
    m_shading->show(display);
}

void DisplayActions::change(const std::function<void(DisplayOptions&)>& how) {
    DisplayOptions display = m_viewport.options();
    how(display);
    const bool areOtherNormals = display.normals != m_viewport.options().normals;
    m_viewport.setOptions(display);
    follow();
    if (areOtherNormals) {
        Q_EMIT normalsChanged();
    }
}

void DisplayActions::cycleWireframe() {
    change([](DisplayOptions& display) {
        display.wireframe = static_cast<WireframeMode>((static_cast<int>(display.wireframe) + 1) % 3);
    });
}

}  // namespace hitscope
