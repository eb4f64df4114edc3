/// \file
/// Builds the pick scene on a thread of its own, after the render scene has been still for a moment; a click
/// that comes earlier waits for it.
#pragma once

#include "widgets/render/pick_scene.h"
#include <QObject>
#include <QTimer>
#include <chrono>
#include <future>

namespace ramure {

class BackgroundPicker : public QObject
{
    Q_OBJECT
public:
    explicit BackgroundPicker(QObject* parent = nullptr);
    ~BackgroundPicker() override;

    /// The scene to pick in from now on. Where nothing that can be picked differs, what was built stays.
    void setScene(std::shared_ptr<const RenderScene> scene);
    /// The structure for the present scene, or null while it is not built.
    [[nodiscard]] std::shared_ptr<const PickScene> ready();
    /// The same; where it is not built, building starts at once and gets this long. Null where that is not
    /// enough: readyChanged follows.
    [[nodiscard]] std::shared_ptr<const PickScene> readyWithin(std::chrono::milliseconds patience);

signals:
    void readyChanged();

private:
    [[nodiscard]] bool picksTheSame(const RenderScene& scene) const;
    void start();
    void finish(quint64 build);
    void abandon();

    std::shared_ptr<const RenderScene> m_scene;
    std::shared_ptr<const PickScene> m_latest; ///< built last, perhaps of an older scene
    bool m_current = true;                     ///< m_latest belongs to m_scene
    std::future<std::shared_ptr<const PickScene>> m_running;
    std::vector<std::future<std::shared_ptr<const PickScene>>>
        m_abandoned; ///< stopped, perhaps still unwinding
    std::stop_source m_stop;
    quint64 m_build = 0;
    QTimer m_rest;
};

} // namespace ramure
