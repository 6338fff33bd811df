#include "base/task_list.h"

#include <gtest/gtest.h>

#include <string>

namespace slicecast {
namespace {

TEST(TaskList, DoesTasksInOrder) {
    TaskList tasks;
    std::string done;
    tasks.add([&] { done += 'a'; });
    tasks.add([&] { done += 'b'; });
    EXPECT_TRUE(tasks.doNext());
    EXPECT_EQ(done, "a");
    tasks.doAll();
    EXPECT_EQ(done, "ab");
    EXPECT_FALSE(tasks.doNext());
}

TEST(TaskList, DoesWhatATaskAddsRightAfterIt) {
    TaskList tasks;
    std::string done;
    tasks.add([&] {
        done += 'a';
        tasks.add([&] {
            done += 'b';
            tasks.add([&] { done += 'c'; });
        });
        tasks.add([&] { done += 'd'; });
    });
    tasks.add([&] { done += 'e'; });
    tasks.doAll();
    EXPECT_EQ(done, "abcde");
}

TEST(TaskList, RepeatsATask) {
    TaskList tasks;
    std::string done;
    tasks.repeat([&, left = 3]() mutable {
        done += 'a';
        return --left > 0;
    });
    tasks.add([&] { done += 'b'; });
    EXPECT_TRUE(tasks.doNext());
    EXPECT_EQ(done, "a");
    tasks.doAll();
    EXPECT_EQ(done, "aaab");
}

TEST(TaskList, TellsTheShareThatIsDone) {
    TaskList tasks;
    EXPECT_EQ(tasks.share(), 0.0);
    for (int i = 0; i < 4; ++i) tasks.add([] {});
    EXPECT_EQ(tasks.share(), 0.0);
    EXPECT_TRUE(tasks.doNext());
    EXPECT_EQ(tasks.share(), 0.25);
    tasks.doAll();
    EXPECT_EQ(tasks.share(), 1.0);
}

}  // namespace
}  // namespace slicecast
