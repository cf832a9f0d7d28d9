// Asks the Modbus server at a port as screens do: `node ask.js modbus-serial 1502` writes what came of it as JSON.
"use strict";

const net = require("node:net");

// Longer than the slowest machine needs, in milliseconds.
const PATIENCE = 30_000;

// Each client in the same few words; what is refused is an error with the code of the exception.
const clients = {
  async "modbus-serial"(port) {
    const Client = require("modbus-serial");
    const client = new Client();
    await client.connectTCP("127.0.0.1", { port });
    client.setID(1);
    client.setTimeout(PATIENCE);
    return {
      coils: async (at, count) => (await client.readCoils(at, count)).data.slice(0, count),
      input: async (at, count) => (await client.readInputRegisters(at, count)).data,
      holding: async (at, count) => (await client.readHoldingRegisters(at, count)).data,
      writeCoil: (at, high) => client.writeCoil(at, high),
      writeRegister: (at, word) => client.writeRegister(at, word),
      writeRegisters: (at, words) => client.writeRegisters(at, words),
      code: (error) => error.modbusCode,
      close: () => new Promise((done) => client.close(done)),
    };
  },

  async jsmodbus(port) {
    const modbus = require("jsmodbus");
    const socket = new net.Socket();
    const client = new modbus.client.TCP(socket, 1, PATIENCE);
    await new Promise((done, failed) => {
      socket.once("connect", done);
      socket.once("error", failed);
      socket.connect({ host: "127.0.0.1", port });
    });
    const values = async (asked) => Array.from((await asked).response.body.valuesAsArray);
    return {
      coils: async (at, count) => (await values(client.readCoils(at, count))).slice(0, count).map(Boolean),
      input: (at, count) => values(client.readInputRegisters(at, count)),
      holding: (at, count) => values(client.readHoldingRegisters(at, count)),
      writeCoil: (at, high) => client.writeSingleCoil(at, high),
      writeRegister: (at, word) => client.writeSingleRegister(at, word),
      writeRegisters: (at, words) => client.writeMultipleRegisters(at, words),
      code: (error) => error.response.body.code,
      close: () => socket.end(),
    };
  },
};

// Reads until that is there: what is written arrives with the next scan.
async function becomes(read, wanted) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const got = await read();
    if (JSON.stringify(got) === JSON.stringify(wanted) || Date.now() > end) return got;
  }
}

async function main(name, port) {
  const client = await clients[name](Number(port));
  const refused = (asked) => asked.then(() => null, client.code);
  await client.writeCoil(0, true);
  const bit = await becomes(() => client.coils(10, 1), [true]);
  // 1.5, the high word first.
  await client.writeRegisters(0, [0x3fc0, 0]);
  const real = await becomes(() => client.holding(2048, 2), [0x3fc0, 0]);
  const rows = [];
  for (let at = 0; at < 1000; at += 125) rows.push(...(await client.input(at, 125)));
  const answers = {
    bit,
    real,
    last: rows.slice(-2),
    refused: [
      await refused(client.holding(5000, 1)),
      await refused(client.writeCoil(10, true)),
      await refused(client.writeRegister(0, 1)),
    ],
  };
  await client.close();
  console.log(JSON.stringify(answers));
}

main(...process.argv.slice(2));
