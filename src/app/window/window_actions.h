// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QMainWindow;

namespace hitscope {

struct AppSettings;
class CameraActions;
class ChangeActions;
class CutActions;
class DiscardGuard;
class DisplayActions;
class EditActions;
class ExchangeActions;
class ExportActions;
class FileActions;
class FullView;
class GoToVertex;
class HelpActions;
class HitActions;
class HitEffects;
class InspectActions;
class LightActions;
class MeshActions;
class NoticeBar;
class PictureActions;
class PipelineChooser;
class ProjectileActions;
class RepeatActions;
class SceneFiles;
class Session;
class SessionCollector;
class SessionFiles;
class ShotActions;
class TextureChooser;
class TextureLocator;
class ThemeActions;
class TimeActions;
class Viewport;
class WindowView;

/// What fills the window's menus, tool bar and docks.
struct WindowActions {
    /// What they work with; all of it outlives them. They belong to `window`.
    struct Parts {
        Session& session;
        AppSettings& settings;
        HitEffects& effects;
        Viewport& viewport;
        SceneFiles& files;
        SessionFiles& sessions;
        DiscardGuard& guard;
        NoticeBar& notice;
        WindowView& view;
        QMainWindow& window;
    };
    /// Makes all of them, once. Settings have been loaded: some go by the session's or the viewport's.
    void make(const Parts& parts);

    CameraActions* cameras = nullptr;
    ChangeActions* change = nullptr;
    SessionCollector* collector = nullptr;
    CutActions* cut = nullptr;
    DisplayActions* display = nullptr;
    EditActions* edit = nullptr;
    ExchangeActions* exchange = nullptr;
    ExportActions* exports = nullptr;
    FileActions* file = nullptr;
    FullView* fullView = nullptr;
    GoToVertex* goToVertex = nullptr;
    HelpActions* help = nullptr;
    HitActions* hits = nullptr;
    InspectActions* inspect = nullptr;
    LightActions* lights = nullptr;
    MeshActions* mesh = nullptr;
    PictureActions* pictures = nullptr;
    PipelineChooser* pipelines = nullptr;
    ProjectileActions* projectile = nullptr;
    RepeatActions* repeat = nullptr;
    ShotActions* shots = nullptr;
    TextureChooser* textureChooser = nullptr;
    TextureLocator* textureLocator = nullptr;
    ThemeActions* themes = nullptr;
    TimeActions* time = nullptr;
};

}  // namespace hitscope
