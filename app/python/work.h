/// \file
/// What a tree or a project of Python stands for: a scene, or the mesh of a file, with the results that were
/// made of it.
#pragma once

#include "app/cli/input.h"
#include "app/python/errors.h"
#include "app/python/python_progress.h"
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace ramure::python {

/// One at a time works on it, whichever thread it is: others wait, with the interpreter's lock released.
class Work
{
public:
    /// \param extras keys of the project file that this version does not know
    explicit Work(cli::Input input, std::string name, std::string extras = {});

    /// Runs act(progress), which returns Expected<T>, without the interpreter's lock, and returns its value.
    /// \throws Raised, what the callback raised; Invalid where it is closed, or where the callback of the
    /// work that is going on calls this.
    template <class Act> auto run(const pybind11::object& callback, Act&& act)
    {
        PythonProgress progress(callback);
        auto result = [&] {
            const pybind11::gil_scoped_release released;
            const Turn turn(*this);
            return act(progress.progress());
        }();
        progress.rethrow();
        return taken(std::move(result));
    }
    /// Forgets everything. What is used afterwards is an error.
    void close();

    // Inside of run() alone.
    [[nodiscard]] cli::Input& input() { return *m_input; }
    [[nodiscard]] TreePipeline& pipeline() { return *m_pipeline; }
    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] const std::string& extras() const { return m_extras; }
    /// Errors: Invalid (a mesh), Unknown (the node is gone).
    Expected<Scene*> scene();
    Expected<Node*> tree(NodeId id);
    /// Has to be called when the scene was changed.
    void touched();
    /// Evaluates a tree. Errors: those of TreePipeline.
    Expected<TreeResult> grown(NodeId id, Stage last, const Progress& progress);

private:
    class Turn
    {
    public:
        explicit Turn(Work& work);
        ~Turn() { m_work.m_owner = std::thread::id(); }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        Work& m_work;
        std::unique_lock<std::mutex> m_lock;
    };

    std::mutex m_mutex;
    std::atomic<std::thread::id> m_owner; ///< who holds it
    std::unique_ptr<cli::Input> m_input;  ///< null: closed
    std::unique_ptr<TreePipeline> m_pipeline;
    std::string m_name;
    std::string m_extras;
};

} // namespace ramure::python
