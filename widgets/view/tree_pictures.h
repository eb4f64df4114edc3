/// \file
/// Small pictures of single trees, grown and drawn in the background.
#pragma once

#include "core/params/node_params.h"
#include "core/qt/session/jobs/job.h"
#include "widgets/view/render/camera.h"
#include <QImage>
#include <QSize>
#include <functional>
#include <memory>
#include <optional>

namespace ramure {

struct TreePicture
{
    QImage image;
    Camera camera; ///< that it was taken with
};

class TreePictures : public QObject
{
    Q_OBJECT
public:
    using Take = std::function<void(Expected<TreePicture>&&)>;

    explicit TreePictures(QObject* parent = nullptr);
    ~TreePictures() override;

    /// The tree alone at its place of growth: all of it, or as \p camera sees it, so that trees can be
    /// compared. A newer wish replaces the one at work, whose \p take
    /// is not called. \param size pixels. Errors given to \p take: those of the tree and of the driver.
    void draw(const NodeParams& params, QSize size, Take take, const std::optional<Camera>& camera = {});
    /// What is at work ends untold.
    void stop();
    [[nodiscard]] bool isBusy() const { return m_job.isRunning(); }

private:
    struct Drawer;
    static void deleteOnMainThread(Drawer* drawer);

    std::shared_ptr<Drawer> m_drawer; ///< only the job's thread draws with it
    Job m_job;
};

} // namespace ramure
