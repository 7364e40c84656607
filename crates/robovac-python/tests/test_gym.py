"""The environments."""

import copy
import pickle
import signal
import warnings

import gymnasium
import numpy as np
import pytest
import robovac
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode
from robovac.gym import GAINS, OI_NAMES, TRUTH_NAMES, RewardWeights

ID = "robovac/Clean-v0"
SETS = ["oi", "map", "truth", ("oi", "map", "truth")]


def ahead(count):
    actions = np.zeros((count, 2), np.float32)
    actions[:, 0] = 1.0
    return actions


@pytest.mark.parametrize("observation", SETS)
@pytest.mark.parametrize("action", ["twist", "wheels"])
def test_gymnasiums_checker_has_nothing_to_say(observation, action):
    env = gymnasium.make(ID, observation=observation, action=action, rooms="bedroom", render_mode="rgb_array")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # Distances and speeds of "truth" have no bounds; a rendered picture needs no second environment.
        warnings.filterwarnings("ignore", message=".*(infinity|unbounded).*")
        check_env(env.unwrapped, skip_render_check=True)
    env.reset(seed=1)
    frame = env.render()
    assert frame.dtype == np.uint8 and frame.shape == (480, 480, 3) and len(np.unique(frame)) > 3
    env.close()


@pytest.mark.parametrize("observation", SETS)
def test_observations_lie_in_their_space(observation):
    envs = gymnasium.make_vec(ID, num_envs=40, observation=observation, rooms=["bedroom", "stairs"], noise="harsh")
    observations, infos = envs.reset(seed=3)
    for _ in range(50):
        assert envs.observation_space.contains(observations)
        observations, rewards, *_, infos = envs.step(envs.action_space.sample())
    assert rewards.shape == (40,) and set(GAINS) < set(infos)
    assert len(OI_NAMES) == 33 and len(TRUTH_NAMES) == 24


def test_a_seed_gives_the_same_steps_alone_and_among_others_on_any_number_of_threads():
    def steps(envs):
        rng = np.random.default_rng(5)
        seen = [envs.reset(seed=11)[0]["oi"].copy()]
        for _ in range(100):
            seen.append(envs.step(rng.uniform(-1, 1, (64, 2)))[0]["oi"].copy())
        return np.array(seen)

    make = lambda threads: gymnasium.make_vec(ID, num_envs=64, observation=("oi", "map"), flats=3, threads=threads)
    one, two = steps(make(1)), steps(make(3))
    assert np.array_equal(one, two)
    alone = gymnasium.make(ID, observation="oi", flats=3).unwrapped
    rng = np.random.default_rng(5)
    seen = [alone.reset(seed=11 + 7)[0]]
    for _ in range(100):
        seen.append(alone.step(rng.uniform(-1, 1, (64, 2))[7])[0])
    assert np.array_equal(np.array(seen), one[:, 7])
    assert not np.array_equal(steps(make(1))[:, 0], one[:, 1])


def test_observations_share_one_array_unless_copies_are_wanted():
    envs = gymnasium.make_vec(ID, num_envs=2, rooms="bedroom")
    first, _ = envs.reset(seed=1)
    assert envs.step(ahead(2))[0] is first
    envs = gymnasium.make_vec(ID, num_envs=2, rooms="bedroom", copy=True)
    first, _ = envs.reset(seed=1)
    assert envs.step(ahead(2))[0] is not first


def test_a_reward_is_the_sum_of_what_was_gained_and_can_be_replaced():
    envs = gymnasium.make_vec(ID, num_envs=8, rooms="bedroom")
    envs.reset(seed=1)
    weights, total = RewardWeights(), np.zeros(8)
    for _ in range(100):
        _, rewards, _, _, infos = envs.step(ahead(8))
        parts = [infos[name] for name in GAINS]
        worths = [weights.swept_m2, weights.turned_rad, weights.bump, weights.second, weights.fall, weights.finish]
        assert rewards == pytest.approx(sum(worth * part for worth, part in zip(worths, parts)))
        total += rewards
    assert total.max() > 1
    envs = gymnasium.make_vec(ID, num_envs=8, rooms="bedroom", rewards=lambda infos: -infos["bumps"])
    envs.reset(seed=1)
    rewards = sum(envs.step(ahead(8))[1].sum() for _ in range(100))
    assert rewards <= -4


def ended(mode):
    """Steps of two robots whose episodes have three steps."""
    envs = gymnasium.make_vec(ID, num_envs=2, rooms="bedroom", time_limit_s=0.315, autoreset_mode=mode)
    assert envs.metadata["autoreset_mode"] == AutoresetMode(mode)
    envs.reset(seed=1)
    return envs, [tuple(map(np.copy, envs.step(ahead(2))[:4])) for _ in range(2)] + [envs.step(ahead(2))]


def test_the_next_step_resets():
    envs, steps = ended("NextStep")
    assert [step[3].tolist() for step in steps] == [[False] * 2, [False] * 2, [True] * 2]
    observations, rewards, terminated, truncated, infos = envs.step(ahead(2))
    assert rewards.tolist() == [0, 0] and not truncated.any() and not terminated.any()
    assert observations[:, OI_NAMES.index("left_command")].tolist() == [0, 0] and infos["time_s"].tolist() == [0, 0]
    assert envs.step(ahead(2))[4]["time_s"] == pytest.approx([0.105, 0.105])


def test_the_same_step_resets_and_tells_the_last_observation():
    envs, steps = ended(AutoresetMode.SAME_STEP)
    observations, rewards, _, truncated, infos = steps[2]
    command = OI_NAMES.index("left_command")
    assert truncated.all() and observations[:, command].tolist() == [0, 0]
    assert [last[command] for last in infos["final_obs"]] == [1, 1] and infos["_final_obs"].all()
    assert infos["final_info"]["time_s"] == pytest.approx([0.105, 0.105])
    assert not envs.step(ahead(2))[3].any()


def test_without_autoreset_a_mask_resets():
    envs, _ = ended(AutoresetMode.DISABLED)
    with pytest.raises(robovac.UsageError, match="the episode of environment 0 is over; reset it first"):
        envs.step(ahead(2))
    envs.reset(options={"reset_mask": np.array([True, False])})
    with pytest.raises(robovac.UsageError, match="the episode of environment 1 is over"):
        envs.step(ahead(2))
    envs.reset(options={"reset_mask": np.array([False, True])})
    assert not envs.step(ahead(2))[3].any()


def test_what_a_function_rewards_doesnt_count_in_a_step_that_resets():
    envs = gymnasium.make_vec(ID, num_envs=2, rooms="bedroom", time_limit_s=0.315, rewards=lambda infos: -1.0)
    envs.reset(seed=1)
    assert [envs.step(ahead(2))[1].tolist() for _ in range(5)] == [[-1, -1]] * 3 + [[0, 0]] + [[-1, -1]]
    for wrong in (None, np.zeros(3), [0, np.nan]):
        envs = gymnasium.make_vec(ID, num_envs=2, rooms="bedroom", rewards=lambda infos, wrong=wrong: wrong)
        envs.reset(seed=1)
        with pytest.raises(robovac.UsageError, match="must return a number for each of 2 environments; it returned"):
            envs.step(ahead(2))


def test_copies_are_new_environments_with_the_same_arguments():
    settings = dict(observation=("oi", "map"), rooms=robovac.Room.shipped("bedroom"), rewards=RewardWeights(bump=-3))
    for env in (gymnasium.make(ID, **settings), gymnasium.make_vec(ID, num_envs=3, **settings)):
        first = env.reset(seed=4)[0]["map"].copy()
        for again in (pickle.loads(pickle.dumps(env)), copy.deepcopy(env)):
            assert again.observation_space == env.observation_space
            with pytest.raises((robovac.UsageError, gymnasium.error.ResetNeeded)):
                again.unwrapped.step(env.action_space.sample())
            assert np.array_equal(again.reset(seed=4)[0]["map"], first)


# slow: hundreds of flats are laid out until the signal arrives
def test_a_reset_ends_by_a_signal():
    class Stopped(Exception):
        pass

    def stop(*_):
        raise Stopped

    before = signal.signal(signal.SIGALRM, stop)
    try:
        envs = gymnasium.make_vec(ID, num_envs=100_000, flats=100_000)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with pytest.raises(Stopped):
            envs.reset(seed=1)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_falls_end_an_episode():
    envs = gymnasium.make_vec(ID, num_envs=32, rooms="stairs", autoreset_mode="SameStep")
    envs.reset(seed=2)
    falls = 0
    for _ in range(150):
        _, rewards, terminated, _, infos = envs.step(ahead(32))
        assert np.array_equal(terminated, infos["falls"] > 0)
        assert not terminated.any() or rewards[terminated].max() < -8
        falls += terminated.sum()
    assert falls > 0


def test_the_own_map_shows_what_was_swept_and_hit():
    room = robovac.Room.from_array(np.zeros((40, 80)), resolution_m=0.05, start=(1.0, 1.0, 0.0))
    settings = dict(observation=("map", "truth"), rooms=room, start="room", slip="none", noise="off")
    env = gymnasium.make(ID, **settings).unwrapped
    env.reset(seed=0)
    for _ in range(62):
        observation, *_ = env.step([1.0, 0.0])
    patches = observation["map"]
    # The wall is ahead, above the middle; the way that it came is below.
    assert (patches[0, :16] == 0).any() and not (patches[0, 22:] == 0).any()
    assert (patches[0, 22:, 14:18] == 255).all() and (patches[0, 22:, :8] == 128).all()
    assert observation["truth"][0] == pytest.approx(4.0 - 0.17, abs=0.02)
    assert observation["truth"][TRUTH_NAMES.index("distance_8_m")] == pytest.approx(3.83, abs=0.02)


def test_settings_that_wont_do_are_refused():
    for settings, words in [
        ({"observation": "smell"}, "observation can't be 'smell'; use 'oi', 'map', 'truth'"),
        ({"action": "legs"}, "action can't be 'legs'"),
        ({"robot": "r2d2"}, 'there is no robot "r2d2"'),
        ({"slip": "oily"}, 'there is no level of slip "oily"'),
        ({"step_s": 0}, "step_s can't be 0"),
        ({"step_s": "1"}, "step_s can't be '1'"),
        ({"goal": -1}, "goal can't be -1"),
        ({"flats": -1}, "flats can't be -1: "),
        ({"area_m2": 40}, "area_m2 can't be 40: "),
        ({"noise": 3}, "noise can't be 3: "),
        ({"autoreset_mode": "never"}, "autoreset_mode can't be 'never'; use 'NextStep', 'SameStep', 'Disabled'"),
        ({"num_envs": 0}, "num_envs can't be 0; use a whole number from 1"),
        ({"rooms": []}, "give at least one room"),
        ({"charge_percent": (80, 20)}, "the lower first"),
    ]:
        with pytest.raises(robovac.UsageError, match=words):
            gymnasium.make_vec(ID, **{"num_envs": 2, **settings})
    envs = gymnasium.make_vec(ID, num_envs=2, rooms="bedroom")
    with pytest.raises(robovac.UsageError, match=r"call reset\(\) before step\(\)"):
        envs.step(ahead(2))
    envs.reset()
    with pytest.raises(robovac.UsageError, match="the action of environment 1 has NaN"):
        envs.step([[0, 0], [0, np.nan]])
    for actions in (ahead(3), np.zeros(4), np.zeros((1, 4)), "ahead"):
        with pytest.raises(robovac.UsageError, match="one action for each of 2 environments"):
            envs.step(actions)
    for seed, words in [([1], "one for each of 2 environments"), (1.5, "seed can't be 1.5"), (2**64, "seed can't be")]:
        with pytest.raises(robovac.UsageError, match=words):
            envs.reset(seed=seed)
    env = gymnasium.make(ID, rooms="bedroom", time_limit_s=0.105).unwrapped
    env.reset(seed=1)
    for action in (np.zeros((1, 2)), np.zeros(3), None):
        with pytest.raises(robovac.UsageError, match=r"an action is an array of shape \(2,\)"):
            env.step(action)
    env.step(np.zeros(2))
    with pytest.raises(robovac.UsageError, match=r"the episode is over; call reset\(\)"):
        env.step(np.zeros(2))


def test_what_chance_chose_is_told():
    settings = {"flats": 3, "first_flat": 40, "slip": ("none", "harsh"), "noise": ("off", "typical"), "charge_percent": (30, 60)}
    envs = gymnasium.make_vec(ID, num_envs=24, **settings).unwrapped
    with pytest.raises(robovac.UsageError, match=r"call reset\(\) before drawn\(\)"):
        envs.drawn()
    envs.reset(seed=5)
    drawn = envs.drawn()
    assert {one.room for one in drawn} == {None} and {one.flat for one in drawn} == {40, 41, 42}
    assert {one.slip for one in drawn} == {"none", "harsh"} and {one.noise for one in drawn} == {"off", "typical"}
    assert all(30 <= one.charge_percent <= 60 for one in drawn) and len({one.charge_percent for one in drawn}) > 5
    alone = gymnasium.make(ID, **settings).unwrapped
    alone.reset(seed=7)
    assert alone.drawn() == drawn[2]
    named = gymnasium.make(ID, rooms=["bedroom"]).unwrapped
    named.reset(seed=1)
    assert (named.drawn().room, named.drawn().flat) == ("Bedroom", None)
