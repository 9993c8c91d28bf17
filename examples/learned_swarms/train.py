#!/usr/bin/python3
"""Learns a policy for a swarm by PPO (Schulman et al., arXiv 1707.06347), one policy shared by twenty footbots, and writes it as an
experiment file with the controller `feed_forward_network`. docs/how-to/train_in_python.md describes it.

    train.py aggregation --seed 1 --minutes 10 --out learned_aggregation.xml

Needs PyTorch (Debian: python3-torch)."""

import argparse
import time

import numpy
import torch
from swarmanoid.environments import VectorEnv

from policy_file import compare, experiment_with
from tasks import FASTEST, TASKS, WHEELS


class Policy(torch.nn.Module):
    """Mean actions from observations, as the controller feed_forward_network computes them, and a critic."""

    def __init__(self, observations, actions, known, hidden=24):
        super().__init__()
        self.mean = torch.nn.Sequential(torch.nn.Linear(observations, hidden), torch.nn.Tanh(),
                                        torch.nn.Linear(hidden, actions), torch.nn.Sigmoid())
        self.value = torch.nn.Sequential(torch.nn.Linear(observations + known, 48), torch.nn.Tanh(),
                                         torch.nn.Linear(48, 48), torch.nn.Tanh(), torch.nn.Linear(48, 1))
        self.log_deviation = torch.nn.Parameter(torch.full((actions,), -1.2))
        torch.nn.init.uniform_(self.mean[2].weight, -0.1, 0.1)

    def log_probability(self, mean, actions):
        deviations = (actions - mean) / self.log_deviation.exp()
        return (-0.5 * deviations ** 2 - self.log_deviation).sum(dim=-1)


class Trainer:
    """PPO over all robots of all worlds: each is a sample."""

    gamma, trace, clip, epochs, batch = 0.98, 0.95, 0.2, 4, 4000

    def __init__(self, task, seed, worlds=16, steps=50, ticks_per_step=4):
        self.task, self.steps = task, steps
        torch.manual_seed(seed)
        self.env = VectorEnv(task.experiment, worlds, reward=task.reward, observations=task.observations,
                             actions={**WHEELS, **{name: (value, value) for name, value in task.constants.items()}},
                             overrides=task.overrides, seed=1000 * seed, ticks=task.ticks, ticks_per_step=ticks_per_step,
                             threads=2, autoreset_mode="disabled")
        self.constants = torch.from_numpy(self.env.single_action_space.low[0, len(WHEELS):])
        self.begin()
        self.policy = Policy(self.env.observation_space.shape[2], len(WHEELS), self.known.shape[2])
        self.optimiser = torch.optim.Adam(self.policy.parameters(), lr=1e-3)
        self.samples = 0

    def begin(self):
        observations, _ = self.env.reset()
        self.task.begin(self.env.worlds)
        self.look(observations)

    def look(self, observations):
        self.observed = torch.from_numpy(observations)
        self.known = torch.from_numpy(self.task.known(self.env.worlds.poses).astype(numpy.float32))

    def commands(self, actions):
        wheels = (actions.clamp(0, 1) * 2 - 1) * FASTEST
        return torch.cat([wheels, self.constants.expand(*wheels.shape[:2], -1)], dim=2).numpy()

    @torch.no_grad()
    def collect(self):
        """Steps all worlds. @return observations, what the critic knows, actions, their log-probabilities, advantages and returns; and the mean
        reward"""
        kept, rewards, values, ends = [], [], [], []
        for _ in range(self.steps):
            mean = self.policy.mean(self.observed)
            actions = mean + self.policy.log_deviation.exp() * torch.randn_like(mean)
            kept.append((self.observed, self.known, actions, self.policy.log_probability(mean, actions)))
            values.append(self.policy.value(torch.cat([self.observed, self.known], dim=2))[..., 0])
            observations, _, terminated, truncated, _ = self.env.step(self.commands(actions))
            rewards.append(torch.from_numpy(self.env.robot_rewards.astype(numpy.float32)))
            ends.append(bool((terminated | truncated).any()))
            self.look(observations)
            if ends[-1]:
                self.begin()   # all worlds end in the same step
        values.append(self.policy.value(torch.cat([self.observed, self.known], dim=2))[..., 0])
        advantages, advantage = [], torch.zeros_like(values[0])
        for t in reversed(range(self.steps)):
            further = values[t] if ends[t] else values[t + 1]   # a run that is cut off would have gone on as before
            advantage = rewards[t] + self.gamma * further - values[t] + (0 if ends[t] else self.gamma * self.trace) * advantage
            advantages.insert(0, advantage)
        advantages = torch.stack(advantages)
        columns = [torch.stack(column) for column in zip(*kept)] + [advantages, advantages + torch.stack(values[:-1])]
        return [column.flatten(0, 2) for column in columns], float(torch.stack(rewards).mean())

    def learn(self):
        """An iteration: collects samples and improves the policy with them. @return the mean reward"""
        (observed, known, actions, before, advantages, returns), reward = self.collect()
        advantages = (advantages - advantages.mean()) / (advantages.std() + 1e-8)
        self.samples += len(observed)
        for _ in range(self.epochs):
            for chosen in torch.randperm(len(observed)).split(self.batch):
                ratio = (self.policy.log_probability(self.policy.mean(observed[chosen]), actions[chosen]) - before[chosen]).exp()
                gain = torch.minimum(ratio * advantages[chosen], ratio.clamp(1 - self.clip, 1 + self.clip) * advantages[chosen])
                value = self.policy.value(torch.cat([observed[chosen], known[chosen]], dim=1))[:, 0]
                loss = 0.5 * (value - returns[chosen]).pow(2).mean() - gain.mean() - 0.002 * self.policy.log_deviation.sum()
                self.optimiser.zero_grad()
                loss.backward()
                torch.nn.utils.clip_grad_norm_(self.policy.parameters(), 0.5)
                self.optimiser.step()
        return reward


def main():
    """Trains for some minutes, writes the policy, and compares it with the controller by hand."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("task", choices=TASKS)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--out", default="learned.xml", help="experiment file for the policy")
    parser.add_argument("--samples", type=int, help="train with so many, instead of some minutes: does not depend on the machine")
    options = parser.parse_args()
    torch.set_num_threads(1)
    task = TASKS[options.task]()
    trainer, begun, rewards, part = Trainer(task, options.seed), time.time(), [], 0.0
    while part < 1:
        rewards.append(trainer.learn())
        seconds = time.time() - begun
        part = trainer.samples / options.samples if options.samples else seconds / (60 * options.minutes)
        if len(rewards) % 12 == 0 or part >= 1:
            print(f"{seconds:4.0f} s ({time.process_time():4.0f} s of processors), {trainer.samples:8} samples, "
                  f"reward {numpy.mean(rewards[-12:]):.4f}", flush=True)
    with open(options.out, "w") as file:
        file.write(experiment_with(task, trainer.policy.mean))
    learned, by_hand = compare(task, options.out)
    print(f"{task.metric}: learned {learned:.3f}, by hand {by_hand:.3f}, {learned / by_hand:.2f} of it")


if __name__ == "__main__":
    main()
