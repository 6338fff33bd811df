#include "base/task_list.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

struct Work {
    TaskList tasks;
    std::string done;
    int left = 3;

    void a() { done += 'a'; }
    void b() { done += 'b'; }
    void number(std::size_t n) { done += std::to_string(n); }
    void several() {
        done += '(';
        tasks.add<&Work::nested>(*this);
        tasks.add<&Work::b>(*this);
    }
    void nested() {
        done += '[';
        tasks.add<&Work::a>(*this);
    }
    bool again() {
        done += '.';
        tasks.add<&Work::number>(*this, static_cast<std::size_t>(left));
        return --left > 0;
    }
};

void endOf(Work& work) {
    work.done += '!';
}

TEST(TaskList, DoesTasksInOrder) {
    Work work;
    work.tasks.add<&Work::a>(work);
    work.tasks.add<&Work::number>(work, 42);
    work.tasks.add<endOf>(work);
    EXPECT_TRUE(work.tasks.doNext());
    EXPECT_EQ(work.done, "a");
    work.tasks.doAll();
    EXPECT_EQ(work.done, "a42!");
    EXPECT_FALSE(work.tasks.doNext());
}

TEST(TaskList, DoesWhatATaskAddsRightAfterIt) {
    Work work;
    work.tasks.add<&Work::several>(work);
    work.tasks.add<endOf>(work);
    work.tasks.doAll();
    EXPECT_EQ(work.done, "([ab!");
}

TEST(TaskList, RepeatsATaskAfterWhatItAdds) {
    Work work;
    work.tasks.add<&Work::again>(work);
    work.tasks.add<endOf>(work);
    work.tasks.doAll();
    EXPECT_EQ(work.done, ".3.2.1!");
}

TEST(TaskList, TellsTheShareThatIsDone) {
    Work work;
    EXPECT_EQ(work.tasks.share(), 0.0);
    for (int i = 0; i < 4; ++i) work.tasks.add<&Work::a>(work);
    EXPECT_TRUE(work.tasks.doNext());
    EXPECT_EQ(work.tasks.share(), 0.25);
    work.tasks.add<&Work::several>(work);
    double before = 0.0;
    while (work.tasks.doNext()) {
        EXPECT_GE(work.tasks.share(), before);
        before = work.tasks.share();
    }
    EXPECT_EQ(work.tasks.share(), 1.0);
}

}  // namespace
}  // namespace slicecast
