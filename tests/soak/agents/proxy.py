#!/usr/bin/env python3
"""A process between an agent and the platform that breaks their connections:

    proxy.py PORT MEAN SEED

It carries bytes between its own port, which it prints, and PORT. After MEAN
bytes on average something happens to a connection, wherever a message is by
then. At the end of its input it prints what it has done, as JSON."""

import asyncio
import collections
import json
import random
import socket
import struct
import sys

# What happens, how often, and whether the connection ends.
MISHAPS = {"reset": 35, "close": 25, "half-open": 18, "freeze": 20,
           "long freeze": 2}


class Proxy:
    def __init__(self, port, mean, seed):
        self.port, self.mean = port, mean
        self.chance = random.Random(seed)
        self.done = collections.Counter()
        self.kinds = [kind for kind, often in MISHAPS.items()
                      for _ in range(often)]

    async def serve(self, reader, writer):
        """One connection of the agent. Some are ended at once."""
        self.done["connections"] += 1
        if self.chance.random() < 0.05:
            self.done["refused"] += 1
            return reset(writer)
        try:
            other = await asyncio.open_connection("127.0.0.1", self.port)
        except OSError:
            return reset(writer)
        await Connection(self, (reader, writer), other).run()


class Connection:
    def __init__(self, proxy, agent, platform):
        self.proxy = proxy
        self.ends = (agent, platform)
        self.flows = asyncio.Event()
        self.flows.set()
        self.next_mishap()

    def next_mishap(self):
        self.left = self.proxy.chance.uniform(0, 2 * self.proxy.mean)

    async def run(self):
        (from_agent, to_agent), (from_platform, to_platform) = self.ends
        pumps = [asyncio.ensure_future(self.pump(from_agent, to_platform)),
                 asyncio.ensure_future(self.pump(from_platform, to_agent))]
        await asyncio.wait(pumps, return_when=asyncio.FIRST_COMPLETED)
        for pump in pumps:
            pump.cancel()
        await asyncio.gather(*pumps, return_exceptions=True)
        for _, writer in self.ends:
            writer.close()

    async def pump(self, reader, writer):
        """Until one side has gone, or a mishap ends the connection."""
        while True:
            await self.flows.wait()
            data = await reader.read(1 << 16)
            await self.flows.wait()
            if not data:
                return
            self.proxy.done["bytes"] += len(data)
            self.left -= len(data)
            if self.left < 0:
                kept = self.proxy.chance.randrange(len(data) + 1)
                writer.write(data[:kept])
                data = data[kept:]
                if await self.suffer():
                    return
            writer.write(data)
            await writer.drain()

    async def suffer(self):
        """True: the connection has ended."""
        self.next_mishap()
        kind = self.proxy.chance.choice(self.proxy.kinds)
        self.proxy.done[kind] += 1
        if kind.endswith("freeze"):
            self.flows.clear()
            await asyncio.sleep(self.proxy.chance.uniform(3.2, 4.0)
                                if kind.startswith("long")
                                else self.proxy.chance.uniform(0, 0.2))
            self.flows.set()
            return False
        if kind == "half-open":  # what this side says is lost
            await asyncio.sleep(self.proxy.chance.uniform(0, 0.1))
        if kind != "close":
            for _, writer in self.ends:
                reset(writer)
        return True


def reset(writer):
    """The other side gets an error; what is on its way is lost."""
    connection = writer.get_extra_info("socket")
    connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER,
                          struct.pack("ii", 1, 0))
    writer.transport.abort()


async def main():
    port, mean, seed = int(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3])
    proxy = Proxy(port, mean, seed)
    server = await asyncio.start_server(proxy.serve, "127.0.0.1", 0)
    print(server.sockets[0].getsockname()[1], flush=True)
    await asyncio.get_running_loop().run_in_executor(None, sys.stdin.read)
    print(json.dumps(proxy.done), flush=True)


if __name__ == "__main__":
    asyncio.run(main())
