// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/window_actions.h"

#include <QMainWindow>

#include "app/actions/camera_actions.h"
#include "app/actions/change_actions.h"
#include "app/actions/cut_actions.h"
#include "app/actions/display_actions.h"
#include "app/actions/edit_actions.h"
#include "app/actions/exchange_actions.h"
#include "app/actions/export_actions.h"
#include "app/actions/file_actions.h"
#include "app/actions/help_actions.h"
#include "app/actions/hit_actions.h"
#include "app/actions/inspect_actions.h"
#include "app/actions/light_actions.h"
#include "app/actions/mesh_actions.h"
#include "app/actions/picture_actions.h"
#include "app/actions/projectile_actions.h"
#include "app/actions/repeat_actions.h"
#include "app/actions/shot_actions.h"
#include "app/actions/theme_actions.h"
#include "app/actions/time_actions.h"
#include "app/dialogs/go_to_vertex.h"
#include "app/dialogs/texture_chooser.h"
#include "app/dialogs/texture_locator.h"
#include "app/full_view.h"
#include "app/pipeline_chooser.h"
#include "app/session_collector.h"
#include "app/session_files.h"
#include "app/settings/app_settings.h"
#include "app/window/window_view.h"
#include "viewport/viewport.h"

namespace hitscope {

void WindowActions::make(const Parts& parts) {
    Session& session = parts.session;
    Viewport& viewport = parts.viewport;
    QMainWindow& window = parts.window;
    textureChooser = new TextureChooser(session, &window);
    textureLocator = new TextureLocator(session, &window);
    pipelines = new PipelineChooser(session, &window);
    fullView = new FullView(window);
    goToVertex = new GoToVertex(session, viewport, &window);
    hits = new HitActions(session, parts.effects, parts.settings.folder, &window);
    exports = new ExportActions(session, viewport, parts.settings, window);
    file = new FileActions({session, parts.settings, parts.files, parts.sessions, parts.guard,
                            *textureLocator, parts.notice, window});
    QObject::connect(file, &FileActions::startedNew, &viewport, &Viewport::frameAsAtFirst);
    collector = new SessionCollector(session, parts.sessions, parts.view.functions().capture, window);
    edit = new EditActions(session, &window);
    display = new DisplayActions(viewport, *textureChooser, &window);
    themes = new ThemeActions(parts.settings, viewport, &window);
    lights = new LightActions(session, &window);
    time = new TimeActions(session, &window);
    shots = new ShotActions(session, parts.effects, viewport, window);
    projectile = new ProjectileActions(session, window);
    mesh = new MeshActions(session, shots->aimPreview(), window);
    QObject::connect(mesh, &MeshActions::turned, &viewport, &Viewport::frameSelection);
    // Directly: without a cover before and after there is no change that the chooser would follow.
    QObject::connect(&parts.sessions, &SessionFiles::opened, textureChooser, &TextureChooser::follow);
    edit->setEditor(mesh->editor());
    edit->setBrush(viewport.brushTool());
    cameras = new CameraActions(viewport, &window);
    pictures = new PictureActions(viewport, window);
    const auto capture = [&session, &view = parts.view] { return captureSession(session, view.capture()); };
    exchange = new ExchangeActions(
        {viewport, *file, *hits, *shots, *cameras, *exports, *textureLocator, capture}, window);
    inspect = new InspectActions(session, viewport, &window);
    repeat = new RepeatActions(session, viewport, hits->editing(), window);
    help = new HelpActions(session, viewport, window);
    change = new ChangeActions(session, parts.effects, viewport, &window);
    cut = new CutActions(session, change->comparison(), viewport, &window);
}

}  // namespace hitscope
